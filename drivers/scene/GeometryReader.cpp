#include "bem/base/Error.hpp"
#include "bem/base/Schema.hpp"
#include "drivers/scene/OutlineChain.hpp"
#include "drivers/scene/Readers.hpp"
#include "drivers/scene/SceneFile.hpp"
#include "drivers/scene/Text.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <filesystem>
#include <numeric>

namespace epafi::drivers {

namespace {

using bem::InputError;
using bem::message;
using Teuchos::ParameterList;

std::vector<std::string> namesOf(const ParameterList& list, const std::string& key) {
  return list.get<Teuchos::Array<std::string>>(key).toVector();
}

/// Counts holes; checks that they are numbered 1, 2, ... and have vertices and edges.
int countHoles(const ParameterList& geometry, const std::string& path) {
  int holes = 0;
  while (geometry.isParameter(holeKey(holes + 1, "Vertices")) ||
         geometry.isParameter(holeKey(holes + 1, "Edges"))) {
    ++holes;
    for (const char* what : {"Vertices", "Edges"})
      if (!geometry.isParameter(holeKey(holes, what)))
        throw InputError(path, "->", holeKey(holes, what), ": missing");
  }
  for (const auto& item : geometry)
    if (item.first.rfind("Hole ", 0) == 0 && std::stol(item.first.substr(5)) > holes)
      throw InputError(path, "->", item.first, ": holes are numbered 1, 2, ...; hole ",
                       holes + 1, " is missing");
  return holes;
}

bem::Loop readLoop(const ParameterList& geometry, const std::string& prefix,
                   const std::string& path) {
  bem::Loop loop{bem::pointsIn(geometry, prefix + "Vertices"),
                 namesOf(geometry, prefix + "Edges")};
  if (geometry.isParameter(prefix + "Bulges"))
    loop.bulges = geometry.get<Teuchos::Array<double>>(prefix + "Bulges").toVector();
  const std::string key = path + "->" + prefix + "Edges";
  if (loop.edges.size() != loop.vertices.size())
    throw InputError(key, ": ", loop.vertices.size(), " vertices make ",
                     loop.vertices.size(), " edges, but ", loop.edges.size(),
                     " names are given; the polygon closes by itself");
  if (!loop.bulges.empty() && loop.bulges.size() != loop.vertices.size())
    throw InputError(path, "->", prefix, "Bulges: ", loop.vertices.size(),
                     " edges have one bulge each (0: straight), but ", loop.bulges.size(),
                     " are given");
  for (std::size_t i = 0; i < loop.edges.size(); ++i)
    if (loop.edges[i].empty() || loop.edges[i].find_first_of(",{}>") != std::string::npos)
      throw InputError(key, ": edge ", i, " is named '", loop.edges[i],
                       "'; a name is not empty and has none of , { } >");
  return loop;
}

void setLoop(ParameterList& geometry, const std::string& prefix, const bem::Loop& loop) {
  bem::setPoints(geometry, prefix + "Vertices", loop.vertices);
  geometry.set(prefix + "Edges", Teuchos::Array<std::string>(loop.edges));
  if (!loop.bulges.empty())
    geometry.set(prefix + "Bulges", Teuchos::Array<double>(loop.bulges));
}

FilePart partOf(const ParameterList& geometry) {
  FilePart part;
  if (geometry.isParameter("Boundaries"))
    part.boundaries = namesOf(geometry, "Boundaries");
  if (geometry.isParameter("Surface"))
    part.surface = geometry.get<std::string>("Surface");
  if (geometry.isParameter("Scale"))
    part.scale = geometry.get<double>("Scale");
  return part;
}

/// Replaces Geometry->File by the vertices and edges in that file, so that used.xml
/// depends on no other file; without File checks that Vertices and Edges are given.
///
/// \param sceneFile  relative names of files start from its folder
/// \param path  path of the list, for messages
/// \throws bem::InputError if both or neither are given, or if the file has no outline.
void expandGeometryFile(Teuchos::ParameterList& geometry, const std::string& sceneFile,
                        const std::string& path) {
  constexpr const char* ofFile[] = {"File", "Scale", "Surface", "Boundaries"};
  if (!geometry.isParameter("File")) {
    for (const char* key : ofFile)
      if (geometry.isParameter(key))
        throw InputError(path, "->", key, ": is of what a File holds, and none is given");
    for (const char* key : {"Vertices", "Edges"})
      if (!geometry.isParameter(key))
        throw InputError(path, "->", key, ": missing; give Vertices and Edges, ",
                         "or File");
    return;
  }
  for (const auto& item : geometry)
    if (std::find(std::begin(ofFile), std::end(ofFile), item.first) == std::end(ofFile))
      throw InputError(path, "->", item.first, ": give this or File, not both");
  const auto name = geometry.get<std::string>("File");
  const std::string file =
      within(path + "->File: ", [&] { return namedFile(name, sceneFile); });
  const std::string where = file == name ? "" : " (" + file + ")";
  within(message(path, "->File = '", name, "'", where, ": "), [&] {
    const auto extension = std::filesystem::path(name).extension();
    const bool isDrawing = extension == ".dxf" || extension == ".DXF";
    const bem::Loops loops =
        (isDrawing ? readDxf : readGmsh)(readText(file), partOf(geometry));
    for (const char* key : ofFile)
      geometry.remove(key, false);
    setLoop(geometry, "", loops.outer);
    for (std::size_t k = 0; k < loops.holes.size(); ++k)
      setLoop(geometry, message("Hole ", k + 1, " "), loops.holes[k]);
  });
}

}  // namespace

std::string holeKey(int hole, const std::string& what) {
  return message("Hole ", hole, " ", what);
}

bem::Loops readLoops(ParameterList& geometry, const std::string& file,
                     const std::string& path) {
  expandGeometryFile(geometry, file, path);
  const int holes = countHoles(geometry, path);
  bem::Loops loops{readLoop(geometry, "", path), {}};
  for (int hole = 1; hole <= holes; ++hole)
    loops.holes.push_back(readLoop(geometry, holeKey(hole, ""), path));
  return loops;
}

std::shared_ptr<const bem::Outline> makeOutline(const bem::Loops& loops, double length,
                                                const Scene& scene,
                                                const std::string& path) {
  return within(path + ": ", [&] {
    bem::Scaling scaling = bem::scalingOf(loops.outer, scene.isAxisymmetric);
    scaling.length = std::max(scaling.length, length);
    if (scene.symmetry)
      scaling.mirror = Symmetry::boundary;
    return std::make_shared<const bem::Outline>(loops.outer, loops.holes, scaling);
  });
}

namespace {

using bem::Kind;
using bem::Row;

/// Larger meshes are typing errors: their dense matrices would fit on no machine.
constexpr double largestMesh = 1e6;

/// Reads one number per edge, in the order of the user's loop.
std::vector<int> readCounts(const Part& part, const std::string& key, std::size_t edges) {
  if (!part.has(key))
    throw InputError(part.path(key), ": missing; give ", edges,
                     " numbers, one per edge, or ", part.path("Mesh Size"));
  const auto& counts = part.list->get<Teuchos::Array<int>>(key);
  if (static_cast<std::size_t>(counts.size()) != edges)
    throw InputError(part.path(key), ": has ", counts.size(),
                     " numbers, but the polygon has ", edges, " edges",
                     static_cast<std::size_t>(counts.size()) > edges
                         ? "; those of a hole are in Hole <k> Elements per Edge"
                         : "");
  return counts.toVector();
}

/// Converts the user's order on a hole to that of Outline: last but one, ..., 0, last.
std::vector<int> alongHole(const std::vector<int>& counts) {
  std::vector<int> result(counts.rbegin() + 1, counts.rend());
  result.push_back(counts.back());
  return result;
}

std::vector<int> countsFromSize(double size, const Part& part,
                                const bem::Outline& outline) {
  std::vector<int> counts;
  for (const bem::Edge& edge : outline.edges()) {
    // Rounding must not add an element if the length is a multiple of the size.
    const double count =
        std::ceil(edge.curve.length() * outline.scaling().length / size * (1 - 1e-12));
    if (count > largestMesh)
      throw InputError(part.path("Mesh Size"), " = ", size, ": gives ", count,
                       " elements on edge '", edge.boundary, "'; at most ", largestMesh,
                       " are possible");
    // an arc element spans at most a quarter of a circle
    const double turns = std::ceil(
        std::abs(edge.curve.angle()) / boost::math::constants::half_pi<double>() - 1e-9);
    counts.push_back(std::max({1, static_cast<int>(count), static_cast<int>(turns)}));
  }
  return counts;
}

std::vector<int> readElements(const Part& part, const bem::Outline& outline) {
  const int holes = outline.loops() - 1;
  if (part.has("Mesh Size")) {
    for (const auto& item : *part.list)
      if (item.first.find("Elements per Edge") != std::string::npos)
        throw InputError(part.path(item.first), ": give this or Mesh Size, not both");
    return countsFromSize(part.list->get<double>("Mesh Size"), part, outline);
  }
  constexpr double usual = 1.0 / 8;  // of the body's diameter
  if (!isSized(*part.list))
    return countsFromSize(usual * outline.diameter(), part, outline);
  const auto edgesOf = [&outline](int loop) {
    return static_cast<std::size_t>(
        std::count_if(outline.edges().begin(), outline.edges().end(),
                      [loop](const bem::Edge& edge) { return edge.loop == loop; }));
  };
  std::vector<int> counts = readCounts(part, "Elements per Edge", edgesOf(0));
  for (int hole = 1; hole <= holes; ++hole) {
    const auto inner =
        alongHole(readCounts(part, holeKey(hole, "Elements per Edge"), edgesOf(hole)));
    counts.insert(counts.end(), inner.begin(), inner.end());
  }
  for (const auto& item : *part.list)
    if (item.first.rfind("Hole ", 0) == 0 && std::stol(item.first.substr(5)) > holes)
      throw InputError(part.path(item.first), ": the body has ", holes, " holes");
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const bem::Curve& curve = outline.edge(static_cast<int>(k)).curve;
    constexpr double halfACircle = boost::math::constants::pi<double>() * (1 + 1e-12);
    if (std::abs(curve.angle()) > halfACircle * counts[k])
      throw InputError(part.path("Elements per Edge"), ": ", counts[k],
                       " on an edge of '", outline.edge(static_cast<int>(k)).boundary,
                       "' that turns by ",
                       std::abs(curve.angle()) * boost::math::constants::radian<double>(),
                       " degrees; an element turns by 180 at most");
  }
  if (std::accumulate(counts.begin(), counts.end(), 0.0) > largestMesh)
    throw InputError(part.path("Elements per Edge"), ": more than ", largestMesh,
                     " elements");
  return counts;
}

}  // namespace

bem::SchemaRows meshRows(const char* degree) {
  Row ownDegree =
      Row("Degree", Kind::Whole, "1", {1, 25},
          "polynomial degree of the displacement; at least 2 on arcs whose elements turn "
          "by more than 16 degrees");
  return {
      Row("Elements per Edge", Kind::Counts, "1", bem::from(1),
          "equal elements on each edge of the outer polygon; or give Mesh Size"),
      Row("Hole <k> Elements per Edge", Kind::Counts, "1", bem::from(1),
          "equal elements on each edge of hole k"),
      Row("Mesh Size", Kind::Real, "length", bem::above(0),
          "largest element; each edge gets the smallest number of equal ones; without it "
          "and Elements per Edge an eighth of the body's diameter"),
      degree != nullptr ? ownDegree.defaultValue(degree) : ownDegree,
  };
}

bool isSized(const ParameterList& mesh) {
  return std::any_of(mesh.begin(), mesh.end(), [](const auto& item) {
    return item.first == "Mesh Size" ||
           item.first.find("Elements per Edge") != std::string::npos;
  });
}

void readMesh(const Part& own, const Part& discretization, Body& body) {
  body.elementsPerEdge =
      readElements(isSized(*own.list) ? own : discretization, *body.outline);
  for (std::size_t k = 0; k < body.elementsPerEdge.size(); ++k)
    if (body.outline->isAxis(static_cast<int>(k)))
      body.elementsPerEdge[k] = 1;
  body.degree = (own.has("Degree") ? own : discretization).list->get<int>("Degree");
}

}  // namespace epafi::drivers
