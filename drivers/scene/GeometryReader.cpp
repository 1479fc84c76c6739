#include "bem/base/Error.hpp"
#include "bem/base/Schema.hpp"
#include "drivers/scene/OutlineChain.hpp"
#include "drivers/scene/Readers.hpp"
#include "drivers/scene/SceneFile.hpp"
#include "drivers/scene/Text.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>

#include <algorithm>
#include <filesystem>

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

/// Replaces Geometry->File by the vertices and edges in that file, so that used.xml
/// depends on no other file; without File checks that Vertices and Edges are given.
///
/// \param sceneFile  relative names of files start from its folder
/// \param path  path of the list, for messages
/// \throws bem::InputError if both or neither are given, or if the file has no outline.
void expandGeometryFile(Teuchos::ParameterList& geometry, const std::string& sceneFile,
                        const std::string& path) {
  if (!geometry.isParameter("File")) {
    for (const char* key : {"Vertices", "Edges"})
      if (!geometry.isParameter(key))
        throw InputError(path, "->", key, ": missing; give Vertices and Edges, ",
                         "or File");
    return;
  }
  for (const auto& item : geometry)
    if (item.first != "File")
      throw InputError(path, "->", item.first, ": give this or File, not both");
  const auto name = geometry.get<std::string>("File");
  const std::string file =
      (std::filesystem::path(sceneFile).parent_path() / name).string();
  const std::string where = file == name ? "" : " (" + file + ")";
  within(message(path, "->File = '", name, "'", where, ": "), [&] {
    const auto extension = std::filesystem::path(name).extension();
    const bool isDrawing = extension == ".dxf" || extension == ".DXF";
    const bem::Loops loops = (isDrawing ? readDxf : readGmsh)(readText(file));
    geometry.remove("File");
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
                                                const std::string& path) {
  return within(path + ": ", [&] {
    bem::Scaling scaling = bem::scalingOf(loops.outer);
    scaling.length = std::max(scaling.length, length);
    return std::make_shared<const bem::Outline>(loops.outer, loops.holes, scaling);
  });
}

}  // namespace epafi::drivers
