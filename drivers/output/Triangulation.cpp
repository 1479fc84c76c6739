#include "drivers/output/Triangulation.hpp"

#include "bem/base/Error.hpp"
#include "drivers/process/ChildProgram.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <unistd.h>

namespace epafi::drivers {

namespace {

namespace fs = std::filesystem;

/// Largest size of a triangle, over the diameter of the outline.
constexpr double largest = 1.0 / 40;
/// Nodes closer than this are merged: no plot can separate them.
constexpr double smallest = 1e-7;

/// A temporary folder, deleted by the destructor.
class Scratch {
 public:
  Scratch() {
    std::string name = (fs::temp_directory_path() / "epafi-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      throw bem::InputError("fields: no folder can be made in '",
                            fs::temp_directory_path().string(),
                            "': ", std::strerror(errno));
    path_ = name;
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  std::string file(const char* name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

/// The vertices of each closed line.
std::vector<std::vector<bem::Vec2>> polygons(const bem::Mesh& mesh) {
  std::vector<std::vector<bem::Vec2>> loops(
      static_cast<std::size_t>(mesh.outline().loops()));
  for (int e = 0; e < mesh.size(); ++e) {
    const bem::Element& element = mesh[e];
    auto& loop = loops[mesh.outline().edge(element.piece.edge).loop];
    const double angle = std::abs(element.curve.angle());
    const int parts = std::max(static_cast<int>(std::ceil(2 * element.half / largest)),
                               static_cast<int>(std::ceil(angle / 0.1)));
    for (int k = 0; k < std::max(parts, 1); ++k) {
      const bem::Vec2 x = element.curve.point(-1 + 2.0 * k / std::max(parts, 1));
      if (loop.empty() ||
          (norm(x - loop.back()) > smallest && norm(x - loop.front()) > smallest))
        loop.push_back(x);
    }
  }
  return loops;
}

void write(const std::string& file, const std::vector<std::vector<bem::Vec2>>& loops) {
  std::ofstream out(file);
  out << std::setprecision(17) << largest << "\n" << loops.size() << "\n";
  for (const auto& loop : loops) {
    out << loop.size() << "\n";
    for (const bem::Vec2& x : loop)
      out << x.x << " " << x.y << "\n";
  }
}

Triangulation read(const std::string& file, const bem::Outline& outline) {
  std::ifstream in(file);
  std::size_t points = 0;
  std::size_t triangles = 0;
  in >> points >> triangles;
  Triangulation result;
  for (std::size_t i = 0; i < points && in; ++i) {
    bem::Vec2 x;
    int boundary = 0;
    in >> x.x >> x.y >> boundary;
    result.points.push_back(outline.physical(x));
    result.onBoundary.push_back(boundary != 0);
  }
  for (std::size_t i = 0; i < triangles && in; ++i) {
    std::array<int, 3> corners{};
    in >> corners[0] >> corners[1] >> corners[2];
    result.corners.push_back(corners);
  }
  if (!in || triangles == 0)
    throw bem::InputError("fields: the inside cannot be cut into triangles: none came");
  return result;
}

}  // namespace

Triangulation triangulate(const bem::Mesh& mesh) {
  const Scratch scratch;
  const std::string in = scratch.file("outline");
  const std::string out = scratch.file("triangles");
  write(in, polygons(mesh));
  const std::string program = besideProgram("libexec/epafi/triangulate");
  if (!runChild(program, {in, out}, "fields",
                "it is built and installed along with epafi"))
    throw bem::InputError("fields: the inside cannot be cut into triangles: '", program,
                          "' failed");
  return read(out, mesh.outline());
}

}  // namespace epafi::drivers
