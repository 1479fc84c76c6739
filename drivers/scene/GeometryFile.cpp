#include "drivers/scene/GeometryFile.hpp"

#include "bem/base/Error.hpp"
#include "drivers/scene/GmshOutline.hpp"
#include "drivers/scene/SceneFile.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_TwoDArray.hpp>

#include <filesystem>

namespace epafi::drivers {

namespace {

using bem::InputError;
using bem::message;

void setLoop(Teuchos::ParameterList& geometry, const std::string& prefix,
             const bem::Loop& loop) {
  const auto size =
      static_cast<Teuchos::TwoDArray<double>::size_type>(loop.vertices.size());
  Teuchos::TwoDArray<double> table(size, 2);
  for (Teuchos::TwoDArray<double>::size_type i = 0; i < size; ++i) {
    table(i, 0) = loop.vertices[i].x;
    table(i, 1) = loop.vertices[i].y;
  }
  geometry.set(prefix + "Vertices", table);
  geometry.set(prefix + "Edges", Teuchos::Array<std::string>(loop.edges));
  if (!loop.bulges.empty())
    geometry.set(prefix + "Bulges", Teuchos::Array<double>(loop.bulges));
}

}  // namespace

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
  try {
    const Loops loops = readGmsh(readText(file));
    geometry.remove("File");
    setLoop(geometry, "", loops.outer);
    for (std::size_t k = 0; k < loops.holes.size(); ++k)
      setLoop(geometry, message("Hole ", k + 1, " "), loops.holes[k]);
  } catch (const InputError& error) {
    throw InputError(path, "->File = '", name, "' (", file, "): ", error.what());
  }
}

}  // namespace epafi::drivers
