#include "drivers/scene/GmshMesh.hpp"

#include "drivers/scene/GmshSections.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace epafi::drivers {

namespace {

using bem::InputError;
using bem::message;
using Sections = GmshSections;
using Tag = NodeTag;
using Mesh = GmshMesh;

void readFormat(Sections& file) {
  file.need("the format");
  const std::string version = file.word("the format's version");
  const Tag type = file.whole("the file type");
  if (version != "4.1")
    file.fail(message("format ", version, " is not read, only 4.1; export it again by ",
                      "gmsh OLD.msh -save -format msh41 -o NEW.msh"));
  file.setType(type);
}

void readNames(Sections& file, Mesh& mesh) {
  file.need("the number of physical names");
  for (Tag n = file.count("the number of physical names"); n > 0; --n) {
    file.need("a physical name");
    const Tag dimension = file.whole("a dimension");
    const Tag tag = file.whole("a physical tag");
    const std::string name = file.word("a physical name");
    if (!whyNoName(name).empty())
      file.fail(whyNoName(name));
    if (dimension == 1)
      mesh.names[tag] = name;
    if (dimension == 2)
      mesh.surfaces[tag] = name;
  }
}

/// A tag that is negative for reversed curves.
Tag unsignedTag(Tag tag) {
  return tag < 0 && tag != std::numeric_limits<Tag>::min() ? -tag : tag;
}

/// Reads the rest of a point or curve behind its tag: bounding box, then physical groups.
std::vector<Tag> groupsOfEntity(Sections& file, int reals) {
  for (int i = 0; i < reals; ++i)
    file.real("a bounding box");
  std::vector<Tag> groups;
  for (Tag g = file.count("the number of physical tags"); g > 0; --g)
    groups.push_back(unsignedTag(file.whole("a physical tag")));
  return groups;
}

/// Reads points, curves and surfaces; the rest of the section is skipped.
void readEntities(Sections& file, Mesh& mesh) {
  file.need("the numbers of entities");
  const Tag points = file.count("the number of points");
  const Tag curves = file.count("the number of curves");
  const Tag surfaces = file.count("the number of surfaces");
  file.count("the number of volumes");
  for (Tag n = 0; n < points; ++n) {
    file.need("a point");
    file.whole("a point's tag");
    groupsOfEntity(file, 3);
  }
  for (Tag n = 0; n < curves; ++n) {
    file.need("a curve");
    const Tag tag = file.whole("a curve's tag");
    mesh.groups[tag] = groupsOfEntity(file, 6);
    for (Tag ends = file.count("the number of end points"); ends > 0; --ends)
      file.whole("a point's tag");
  }
  for (Tag n = 0; n < surfaces; ++n) {
    file.need("a surface");
    file.whole("a surface's tag");
    GmshFace face{groupsOfEntity(file, 6), {}};
    for (Tag around = file.count("the number of curves"); around > 0; --around)
      face.curves.push_back(unsignedTag(file.whole("a curve's tag")));
    mesh.faces.push_back(std::move(face));
  }
}

/// Returns the number of blocks and skips the other numbers of the line.
Tag countBlocks(Sections& file, const char* what) {
  file.need(what);
  const Tag blocks = file.count("the number of blocks");
  for (int i = 0; i < 3; ++i)
    file.count(what);
  return blocks;
}

void readNodes(Sections& file, Mesh& mesh) {
  for (Tag blocks = countBlocks(file, "the numbers of nodes"); blocks > 0; --blocks) {
    file.need("a block of nodes");
    const Tag dimension = file.whole("a dimension");
    file.whole("an entity's tag");
    const bool parametric = file.whole("'parametric'") != 0;
    const Tag count = file.count("the number of nodes");
    std::vector<Tag> tags;
    for (Tag n = 0; n < count; ++n) {
      file.need("a node's tag");
      tags.push_back(file.count("a node's tag"));
    }
    for (const Tag tag : tags) {
      file.need("a node");
      const double x = file.real("x");
      const double y = file.real("y");
      const double z = file.real("z");
      for (Tag i = 0; parametric && i < std::min<Tag>(dimension, 3); ++i)
        file.real("a parameter");
      if (!mesh.nodes.insert({tag, {{x, y}, z}}).second)
        file.fail(message("node ", tag, " is given twice"));
    }
  }
}

bool isOfHigherOrder(Tag type) {
  return (26 <= type && type <= 28) || (62 <= type && type <= 66);
}

Tag groupOf(const Sections& file, const Mesh& mesh, Tag curve) {
  const auto found = mesh.groups.find(curve);
  if (found == mesh.groups.end() || found->second.empty())
    return 0;
  if (found->second.size() > 1)
    file.fail(message("curve ", curve, " belongs to ", found->second.size(),
                      " physical groups; an edge has one name"));
  return found->second.front();
}

/// Reads a block of line elements on a curve.
void readLines(Sections& file, Mesh& mesh, Tag type, Tag curve, Tag count) {
  const Tag group = groupOf(file, mesh, curve);
  constexpr Tag segment = 1;
  constexpr Tag secondOrder = 8;
  for (Tag n = 0; n < count; ++n) {
    file.need("an element");
    file.count("an element's number");
    if (isOfHigherOrder(type))
      file.fail(
          "a line element of third or higher order; write straight ones or arcs "
          "(Mesh.ElementOrder = 1 or 2)");
    if (type != segment && type != secondOrder)
      file.fail(message("an element of type ", type, " on a curve"));
    GmshLine line;
    line.from = file.count("a node's tag");
    line.to = file.count("a node's tag");
    if (type == secondOrder)
      line.middle = file.count("a node's tag");
    line.group = group;
    line.curve = curve;
    line.fileLine = file.number();
    if (group != 0)
      mesh.lines.push_back(line);
  }
}

/// Reads points and lines; the elements in the plane behind them are skipped.
void readElements(Sections& file, Mesh& mesh) {
  for (Tag blocks = countBlocks(file, "the numbers of elements"); blocks > 0; --blocks) {
    file.need("a block of elements");
    const Tag dimension = file.whole("a dimension");
    const Tag entity = file.whole("an entity's tag");
    const Tag type = file.whole("an element's type");
    const Tag count = file.count("the number of elements");
    if (dimension == 1) {
      readLines(file, mesh, type, entity, count);
      continue;
    }
    if (dimension > 1 && file.isBinary())
      return;  // Gmsh writes them behind all lines
    for (Tag n = 0; n < count; ++n) {
      file.need("an element");
      file.count("an element's number");
      file.count("a node's tag");
    }
  }
}

}  // namespace

GmshMesh readGmshMesh(const std::string& text) {
  struct Section {
    const char* name;
    void (*read)(Sections& file, Mesh& mesh);
  };
  constexpr Section numbers[] = {
      {"Entities", readEntities}, {"Nodes", readNodes}, {"Elements", readElements}};
  Sections file(text);
  Mesh mesh;
  if (!file.next() || !file.is("$MeshFormat"))
    throw InputError(
        "line 1: $MeshFormat is missing; a geometry is a Gmsh mesh (.msh) or a drawing "
        "(.dxf)");
  readFormat(file);
  bool elements = false;
  while (file.next()) {
    if (file.is("$PhysicalNames"))
      readNames(file, mesh);
    for (const Section& section : numbers)
      if (file.is(message("$", section.name).c_str())) {
        file.beginNumbers();
        section.read(file, mesh);
        file.endNumbers(message("$End", section.name));
        elements = elements || section.read == readElements;
        break;
      }
  }
  if (!elements)
    throw InputError("line ", file.number(), ": the file has no $Elements");
  if (mesh.lines.empty())
    throw InputError(
        "no line element belongs to a physical group; name the boundary's curves "
        "(Physical Curve(\"name\") = {...};)");
  return mesh;
}

}  // namespace epafi::drivers
