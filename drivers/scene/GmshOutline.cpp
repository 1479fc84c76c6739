#include "bem/base/Suggestion.hpp"
#include "drivers/scene/GmshSections.hpp"
#include "drivers/scene/OutlineChain.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <limits>
#include <utility>

namespace epafi::drivers {

namespace {

using bem::InputError;
using bem::message;
using bem::Vec2;
using Sections = GmshSections;
using Tag = NodeTag;

struct Node {
  bem::Vec2 place;
  double z = 0;
};

/// A line element of first or second order on a physical curve.
struct Line {
  Tag from = 0;
  Tag to = 0;
  Tag middle = 0;  ///< 0 for a line of first order
  Tag group = 0;
  Tag curve = 0;
  int fileLine = 0;
  double bulge = 0;  ///< of a line of first order
};

/// A surface of the geometry.
struct Face {
  std::vector<Tag> groups;
  std::vector<Tag> curves;  ///< around it
};

/// The boundaries in a .msh file: nodes, physical curves and the line elements on them.
struct Mesh {
  std::map<Tag, std::string> names;     ///< of the physical curves
  std::map<Tag, std::string> surfaces;  ///< likewise
  std::vector<Face> faces;
  std::map<Tag, std::vector<Tag>> groups;  ///< of the curves
  std::map<Tag, Node> nodes;
  std::vector<Line> lines;
};

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
    Face face{groupsOfEntity(file, 6), {}};
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
    Line line;
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

/// Elements other than lines of a physical group are skipped.
Mesh readMesh(const std::string& text) {
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

/// Three points are on a straight line if it turns by less than this [radian].
constexpr double straight = 1e-9;

std::vector<Tag> nodesOf(const Line& line) {
  std::vector<Tag> nodes = {line.from, line.to};
  if (line.middle != 0)
    nodes.push_back(line.middle);
  return nodes;
}

/// The size of the outline.  \throws bem::InputError unless all nodes of the lines exist and have
/// the same z.
double checkNodes(const Mesh& mesh) {
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  double size = 0;
  for (const Line& line : mesh.lines)
    for (const Tag tag : nodesOf(line)) {
      const auto node = mesh.nodes.find(tag);
      if (node == mesh.nodes.end())
        throw InputError("line ", line.fileLine, ": there is no node ", tag);
      const auto& [place, z] = node->second;
      least = std::min(least, z);
      most = std::max(most, z);
      size = std::max({size, std::abs(place.x), std::abs(place.y)});
    }
  if (most - least > 1e-9 * size)
    throw InputError("the outline is not in a plane of constant z: from z = ", least,
                     " to ", most);
  return size;
}

std::string nameOf(const Mesh& mesh, Tag group) {
  const auto name = mesh.names.find(group);
  return name == mesh.names.end() ? std::to_string(group) : name->second;
}

/// tan(angle/4) of the arc through the nodes of a line: its two chords turn by angle/2.
double bulgeOf(const Mesh& mesh, const Line& line) {
  if (line.middle == 0)
    return line.bulge;
  const Vec2 middle = mesh.nodes.at(line.middle).place;
  const Vec2 in = middle - mesh.nodes.at(line.from).place;
  const Vec2 out = mesh.nodes.at(line.to).place - middle;
  const double turn = std::atan2(cross(in, out), dot(in, out));
  constexpr double quarterTurn = boost::math::constants::half_pi<double>();
  if (!(std::abs(turn) <= quarterTurn * (1 + 1e-9)))
    throw InputError(
        "line ", line.fileLine,
        ": the middle node of a line of second order is not between its ends");
  return std::abs(turn) < straight ? 0 : std::tan(0.5 * turn);
}

/// The centre of the circle nearest to places (Kasa's fit); far away, or not finite, where they are
/// on a line.
Vec2 centreOf(const std::vector<Vec2>& places) {
  Vec2 middle;
  for (const Vec2 place : places)
    middle = middle + (1.0 / static_cast<double>(places.size())) * place;
  double xx = 0;
  double xy = 0;
  double yy = 0;
  Vec2 right;
  for (const Vec2 place : places) {
    const Vec2 d = place - middle;
    xx += d.x * d.x;
    xy += d.x * d.y;
    yy += d.y * d.y;
    right = right + 0.5 * dot(d, d) * d;
  }
  const double determinant = xx * yy - xy * xy;
  return middle + (1 / determinant) *
                      Vec2{yy * right.x - xy * right.y, xx * right.y - xy * right.x};
}

/// Makes arcs of the lines of first order on a curve, if their nodes are on a circle: two of equal
/// length, or three, none turning as far as the sides of a hexagon, are no polygon that was meant.
void roundCurve(const Mesh& mesh, const std::vector<Line*>& lines) {
  constexpr double ofSagitta = 1e-3;
  constexpr double ofLength = 1e-6;
  constexpr double sharpest = boost::math::constants::pi<double>() / 3 * (1 - 1e-6);
  std::vector<Vec2> places;
  double longest = 0;
  double shortest = std::numeric_limits<double>::infinity();
  for (const Line* line : lines) {
    if (line->middle != 0)
      return;
    const Vec2 from = mesh.nodes.at(line->from).place;
    const Vec2 to = mesh.nodes.at(line->to).place;
    places.insert(places.end(), {from, to});
    longest = std::max(longest, norm(to - from));
    shortest = std::min(shortest, norm(to - from));
  }
  if (lines.size() < 2 || (lines.size() < 3 && longest - shortest > ofLength * longest))
    return;
  const Vec2 centre = centreOf(places);
  double radius = 0;
  for (const Vec2 place : places)
    radius += norm(place - centre) / static_cast<double>(places.size());
  const double sagitta = longest * longest / (8 * radius);
  if (!(radius < longest / straight) ||
      !(2 * std::asin(std::min(1.0, longest / (2 * radius))) < sharpest) ||
      !std::all_of(places.begin(), places.end(), [&](Vec2 place) {
        return std::abs(norm(place - centre) - radius) <= ofSagitta * sagitta;
      }))
    return;
  for (Line* line : lines) {
    const Vec2 from = mesh.nodes.at(line->from).place;
    const Vec2 to = mesh.nodes.at(line->to).place;
    const double angle = 2 * std::asin(norm(to - from) / (2 * radius));
    line->bulge = std::copysign(std::tan(angle / 4), cross(to - from, centre - from));
  }
}

void roundCurves(Mesh& mesh) {
  std::map<Tag, std::vector<Line*>> curves;
  for (Line& line : mesh.lines)
    curves[line.curve].push_back(&line);
  for (const auto& [curve, lines] : curves)
    roundCurve(mesh, lines);
}

/// Leaves the lines on the border of a physical surface.
void keepBorder(const std::string& surface, Mesh& mesh) {
  std::vector<std::string> names;
  std::map<Tag, int> sides;  // of curves, on faces of the surface
  for (const Face& face : mesh.faces)
    for (const Tag group : face.groups) {
      const auto named = mesh.surfaces.find(group);
      names.push_back(named == mesh.surfaces.end() ? std::to_string(group)
                                                   : named->second);
      for (const Tag curve : face.curves)
        if (names.back() == surface)
          ++sides[curve];
    }
  if (std::find(names.begin(), names.end(), surface) == names.end())
    throw InputError("no physical surface is named '", surface, "'",
                     bem::suggestion(surface, names));
  mesh.lines.erase(
      std::remove_if(mesh.lines.begin(), mesh.lines.end(),
                     [&](const Line& line) { return sides[line.curve] != 1; }),
      mesh.lines.end());
}

}  // namespace

bem::Loops readGmsh(const std::string& text, const FilePart& part) {
  constexpr double rounding = 1e-9;
  Mesh mesh = readMesh(text);
  if (!part.surface.empty())
    keepBorder(part.surface, mesh);
  const double size = checkNodes(mesh);
  roundCurves(mesh);
  OutlinePieces outline;
  outline.same = rounding * size;
  outline.advice =
      "all of its curves need a physical group (lines without one are not read)";
  for (const Line& line : mesh.lines)
    for (const Tag tag : {line.from, line.to})
      outline.nodes[tag] = mesh.nodes.at(tag).place;
  for (const Line& line : mesh.lines)
    outline.pieces.push_back({line.from, line.to, bulgeOf(mesh, line),
                              nameOf(mesh, line.group), line.fileLine});
  return chained(std::move(outline), part);
}

}  // namespace epafi::drivers
