#include "drivers/scene/GmshOutline.hpp"

#include "bem/base/Error.hpp"
#include "drivers/scene/GmshMesh.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <limits>

namespace epafi::drivers {

namespace {

using bem::InputError;
using bem::Vec2;
using Tag = NodeTag;

/// Three points are on a straight line if it turns by less than this [radian].
constexpr double straight = 1e-9;

std::vector<Tag> nodesOf(const GmshLine& line) {
  std::vector<Tag> nodes = {line.from, line.to};
  if (line.middle != 0)
    nodes.push_back(line.middle);
  return nodes;
}

/// \throws bem::InputError unless all nodes of the lines exist and have the same z.
void checkNodes(const GmshMesh& mesh) {
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  double size = 0;
  for (const GmshLine& line : mesh.lines)
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
}

std::string nameOf(const GmshMesh& mesh, Tag group) {
  const auto name = mesh.names.find(group);
  return name == mesh.names.end() ? std::to_string(group) : name->second;
}

/// tan(angle/4) of the arc through the nodes of a line: its two chords turn by angle/2.
double bulgeOf(const GmshMesh& mesh, const GmshLine& line) {
  if (line.middle == 0)
    return 0;
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

}  // namespace

bem::Loops readGmsh(const std::string& text) {
  const GmshMesh mesh = readGmshMesh(text);
  checkNodes(mesh);
  OutlinePieces outline;
  outline.advice =
      "all of its curves need a physical group (lines without one are not read)";
  for (const auto& [tag, node] : mesh.nodes)
    outline.nodes[tag] = node.place;
  for (const GmshLine& line : mesh.lines)
    outline.pieces.push_back({line.from, line.to, bulgeOf(mesh, line),
                              nameOf(mesh, line.group), line.fileLine});
  return chained(outline);
}

}  // namespace epafi::drivers
