#pragma once

#include "Message.hpp"
#include "drivers/scene/SceneReader.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <unistd.h>
#include <vector>

namespace epafi::test {

inline std::string entry(const std::string& name, const std::string& type,
                         const std::string& value) {
  return "<Parameter name=\"" + name + "\" type=\"" + type + "\" value=\"" + value +
         "\"/>\n";
}

/// A word or an expression.
inline std::string parameter(const std::string& name, const std::string& value) {
  return entry(name, "string", value);
}

inline std::string real(const std::string& name, const std::string& value) {
  return entry(name, "double", value);
}

inline std::string elastic(const std::string& young, const std::string& poisson) {
  return real("Young's Modulus", young) + real("Poisson's Ratio", poisson);
}

inline std::string outline(const std::string& vertices, const std::string& edges) {
  return entry("Vertices", "TwoDArray(double)", vertices) +
         entry("Edges", "Array(string)", edges);
}

inline std::string elements(const std::string& perEdge) {
  return entry("Elements per Edge", "Array(int)", perEdge);
}

inline std::string list(const std::string& name, const std::string& content) {
  return "<ParameterList name=\"" + name + "\">" + content + "</ParameterList>\n";
}

inline std::string friction(const std::string& law, const std::string& fields = "") {
  return list("Friction", parameter("Law", law) + fields);
}

/// A small valid scene as XML, by its parts, so that a test can spoil one of them.
struct SceneText {
  std::string material = elastic("200", "0.25");
  std::string geometry = outline("4x2:{0,0, 2,0, 2,1, 0,1}", "{base, right, top, left}");
  std::string base = parameter("Type", "Contact") + parameter("Gap", "0.1*x^2") +
                     friction("Coulomb", parameter("Coefficient", "0.3"));
  std::string top = parameter("Type", "Dirichlet") + parameter("Displacement Y", "-0.01");
  std::string conditions;
  std::string rigid = entry("Fix", "Array(string)", "{X}");
  std::string bodies;
  std::string discretization = elements("{4, 2, 4, 2}");
  std::string rest;

  std::string xml() const {
    return list(
        "A test",
        list("Bodies",
             list("block", list("Material", material) + list("Geometry", geometry) +
                               list("Boundary Conditions",
                                    list("base", base) + list("top", top) + conditions) +
                               list("Rigid Motions", rigid)) +
                 bodies) +
            list("Discretization", discretization) + rest);
  }
};

/// With further lists.
inline SceneText withRest(const std::string& content) {
  SceneText scene;
  scene.rest = content;
  return scene;
}

/// A file that exists while the object does.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& name, const std::string& text)
      : folder_(std::filesystem::temp_directory_path() /
                ("epafi_scene_test_" + std::to_string(::getpid()))),
        path_((folder_ / name).string()) {
    std::filesystem::create_directories(folder_);
    std::ofstream(path_, std::ios::binary) << text;
  }
  ~TemporaryFile() { std::filesystem::remove_all(folder_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::filesystem::path folder_;
  std::string path_;
};

inline drivers::Scene read(const SceneText& text,
                           const std::vector<std::string>& overrides = {}) {
  const TemporaryFile file("scene.xml", text.xml());
  return drivers::readScene(file.path(), overrides);
}

/// The InputError that reading a text ends with; empty if it is read.
inline std::string complaintOf(const std::string& text,
                               const std::string& name = "scene.xml",
                               const std::vector<std::string>& overrides = {}) {
  const TemporaryFile file(name, text);
  const std::string what = messageOf([&] { drivers::readScene(file.path(), overrides); });
  // Every message names the file first.
  if (what.empty() || what.rfind(file.path() + ": ", 0) == 0)
    return what.empty() ? "" : what.substr(file.path().size() + 2);
  return "NO FILE NAMED IN: " + what;
}

}  // namespace epafi::test
