#include "bem/base/Error.hpp"
#include "bem/base/Suggestion.hpp"
#include "drivers/scene/GmshMesh.hpp"
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
using Tag = NodeTag;
using Line = GmshLine;
using Mesh = GmshMesh;

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
  for (const GmshFace& face : mesh.faces)
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
  Mesh mesh = readGmshMesh(text);
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
