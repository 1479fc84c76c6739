#pragma once

#include "bem/base/Error.hpp"
#include "drivers/scene/SceneReader.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <unistd.h>
#include <vector>

namespace epafi::test {

/// A small valid scene as XML, by its parts, so that a test can spoil one of them.
struct SceneText {
  std::string material =
      R"(<Parameter name="Young's Modulus" type="double" value="200"/>
         <Parameter name="Poisson's Ratio" type="double" value="0.25"/>)";
  std::string geometry =
      R"(<Parameter name="Vertices" type='TwoDArray(double)' value="4x2:{0,0, 2,0, 2,1, 0,1}"/>
         <Parameter name="Edges" type='Array(string)' value="{base, right, top, left}"/>)";
  std::string base =
      R"(<Parameter name="Type" type="string" value="Contact"/>
         <Parameter name="Gap" type="string" value="0.1*x^2"/>
         <ParameterList name="Friction">
           <Parameter name="Law" type="string" value="Coulomb"/>
           <Parameter name="Coefficient" type="string" value="0.3"/>
         </ParameterList>)";
  std::string top =
      R"(<Parameter name="Type" type="string" value="Dirichlet"/>
         <Parameter name="Displacement Y" type="string" value="-0.01"/>)";
  std::string conditions;
  std::string rigid = R"(<Parameter name="Fix" type='Array(string)' value="{X}"/>)";
  std::string bodies;
  std::string discretization =
      R"(<Parameter name="Elements per Edge" type='Array(int)' value="{4, 2, 4, 2}"/>)";
  std::string rest;

  std::string xml() const {
    const auto list = [](const std::string& name, const std::string& content) {
      return "<ParameterList name=\"" + name + "\">" + content + "</ParameterList>\n";
    };
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
  try {
    drivers::readScene(file.path(), overrides);
  } catch (const bem::InputError& error) {
    // Every message names the file first.
    const std::string what = error.what();
    return what.rfind(file.path() + ": ", 0) == 0 ? what.substr(file.path().size() + 2)
                                                  : "NO FILE NAMED IN: " + what;
  }
  return "";
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace epafi::test
