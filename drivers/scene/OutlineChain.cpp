#include "drivers/scene/GmshOutline.hpp"

#include "bem/base/Error.hpp"
#include "bem/geometry/Crossing.hpp"
#include "drivers/scene/GmshMesh.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <map>
#include <set>

namespace epafi::drivers {

namespace {

using bem::InputError;
using bem::Loop;
using bem::message;
using bem::Vec2;
using Tag = GmshTag;

/// Two lines whose directions differ by less (in radians) are one edge.
constexpr double straight = 1e-9;

/// Two arcs that meet at a smaller angle (in radians) and whose curvatures differ by a
/// smaller share are parts of one circle: coordinates of 7 digits say no more.
constexpr double oneCircle = 1e-6;

std::vector<Tag> nodesOf(const GmshLine& line) {
  std::vector<Tag> nodes = {line.from, line.to};
  if (line.middle != 0)
    nodes.push_back(line.middle);
  return nodes;
}

/// The lines at every node; exactly two where the mesh is an outline.
std::map<Tag, std::vector<std::size_t>> incidence(const GmshMesh& mesh) {
  std::map<Tag, std::vector<std::size_t>> result;
  std::set<std::pair<std::pair<Tag, Tag>, Tag>> pairs;
  for (std::size_t i = 0; i < mesh.lines.size(); ++i) {
    const GmshLine& line = mesh.lines[i];
    const std::string where = message("line ", line.fileLine, ": ");
    for (const Tag node : nodesOf(line))
      if (mesh.nodes.count(node) == 0)
        throw InputError(where, "there is no node ", node);
    if (line.from == line.to)
      throw InputError(where, "an element from node ", line.from, " to itself");
    if (!pairs.insert({std::minmax(line.from, line.to), line.middle}).second)
      throw InputError(where, "a second element between nodes ", line.from, " and ",
                       line.to, "; an edge has one name");
    result[line.from].push_back(i);
    result[line.to].push_back(i);
  }
  for (const auto& [tag, touching] : result)
    if (touching.size() != 2) {
      const Vec2 place = mesh.nodes.at(tag).place;
      throw InputError("line ", mesh.lines[touching.front()].fileLine, ": at node ", tag,
                       " = (", place.x, ", ", place.y, ") ",
                       touching.size() == 1
                           ? "the outline ends; all of its curves need a physical group"
                           : message(touching.size(), " lines meet; an outline has two"),
                       " (lines without a physical group are not read)");
    }
  return result;
}

void checkPlane(const GmshMesh& mesh) {
  double least = 0;
  double most = 0;
  double size = 0;
  bool first = true;
  for (const GmshLine& line : mesh.lines)
    for (const Tag tag : nodesOf(line)) {
      const GmshNode& node = mesh.nodes.at(tag);
      least = first ? node.z : std::min(least, node.z);
      most = first ? node.z : std::max(most, node.z);
      size = std::max({size, std::abs(node.place.x), std::abs(node.place.y)});
      first = false;
    }
  if (most - least > 1e-9 * size)
    throw InputError("the outline is not in a plane of constant z: from z = ", least,
                     " to ", most);
}

std::string nameOf(const GmshMesh& mesh, Tag group) {
  const auto name = mesh.names.find(group);
  return name == mesh.names.end() ? std::to_string(group) : name->second;
}

bem::Curve curveOf(const Loop& loop, std::size_t i) {
  return {loop.vertices[i], loop.vertices[(i + 1) % loop.vertices.size()],
          loop.bulges[i]};
}

/// tan(angle/4) of the arc through three points: half of its angle is what the chords to
/// the middle one turn by.
double bulgeThrough(Vec2 from, Vec2 middle, Vec2 to, const std::string& where) {
  const double turn =
      std::atan2(cross(middle - from, to - middle), dot(middle - from, to - middle));
  constexpr double quarterTurn = 1.5707963267948966;
  if (!(std::abs(turn) <= quarterTurn * (1 + 1e-9)))
    throw InputError(where +
                     "the middle node of a line of second order is not between its ends");
  return std::abs(turn) < straight ? 0 : std::tan(0.5 * turn);
}

double bulgeOf(const GmshMesh& mesh, const GmshLine& line, Tag from) {
  if (line.middle == 0)
    return 0;
  const Vec2 a = mesh.nodes.at(line.from).place;
  const Vec2 b = mesh.nodes.at(line.to).place;
  const double bulge = bulgeThrough(a, mesh.nodes.at(line.middle).place, b,
                                    message("line ", line.fileLine, ": "));
  return from == line.from ? bulge : -bulge;
}

double twiceArea(const Loop& loop) {
  double area = 0;
  for (std::size_t i = 0; i < loop.vertices.size(); ++i)
    area += loop.bulges[i] == 0 ? 0 : twiceAreaBesideChord(curveOf(loop, i));
  for (std::size_t i = 0; i < loop.vertices.size(); ++i)
    area += cross(loop.vertices[i] - loop.vertices[0],
                  loop.vertices[(i + 1) % loop.vertices.size()] - loop.vertices[0]);
  return area;
}

/// The same loop the other way round: edge i leads from vertex i to i+1 again.
void reverse(Loop& loop, std::vector<Tag>& tags) {
  std::reverse(loop.vertices.begin(), loop.vertices.end());
  std::reverse(tags.begin(), tags.end());
  std::reverse(loop.edges.begin(), loop.edges.end() - 1);
  std::reverse(loop.bulges.begin(), loop.bulges.end() - 1);
  for (double& bulge : loop.bulges)
    bulge = -bulge;
}

/// Does the loop turn, or change its curvature or its name, at vertex i?
bool isCorner(const Loop& loop, std::size_t i) {
  const std::size_t n = loop.vertices.size();
  const std::size_t before = (i + n - 1) % n;
  if (loop.edges[before] != loop.edges[i])
    return true;
  if (loop.bulges[before] != 0 || loop.bulges[i] != 0) {
    const bem::Curve in = curveOf(loop, before);
    const bem::Curve out = curveOf(loop, i);
    return in.isStraight() || out.isStraight() ||
           !(dot(in.tangent(1), out.tangent(-1)) > 0 &&
             std::abs(cross(in.tangent(1), out.tangent(-1))) <= oneCircle &&
             std::abs(in.curvature() - out.curvature()) <=
                 oneCircle * std::abs(in.curvature()));
  }
  const Vec2 in = loop.vertices[i] - loop.vertices[before];
  const Vec2 out = loop.vertices[(i + 1) % n] - loop.vertices[i];
  return !(dot(in, out) > 0 &&
           std::abs(cross(in, out)) <= straight * norm(in) * norm(out));
}

/// Corners only, from the one with the smallest tag on.
Loop merged(const Loop& loop, const std::vector<Tag>& tags) {
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < loop.vertices.size(); ++i)
    if (isCorner(loop, i))
      corners.push_back(i);
  const auto first = std::min_element(
      corners.begin(), corners.end(),
      [&tags](std::size_t a, std::size_t b) { return tags[a] < tags[b]; });
  const std::size_t n = loop.vertices.size();
  const std::size_t start =
      corners.empty() ? static_cast<std::size_t>(
                            std::min_element(tags.begin(), tags.end()) - tags.begin())
                      : *first;
  constexpr double halfACircle = boost::math::constants::pi<double>() * (1 + 1e-6);
  Loop result;
  double angle = 0;  // of the last edge
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = (start + k) % n;
    const double more = 4 * std::atan(loop.bulges[i]);
    if (k == 0 || isCorner(loop, i) || std::abs(angle + more) > halfACircle) {
      result.vertices.push_back(loop.vertices[i]);
      result.edges.push_back(loop.edges[i]);
      result.bulges.push_back(0);
      angle = 0;
    }
    angle += more;
    result.bulges.back() = std::tan(0.25 * angle);
  }
  if (std::all_of(result.bulges.begin(), result.bulges.end(),
                  [](double bulge) { return bulge == 0; }))
    result.bulges.clear();
  return result;
}

std::vector<Loop> chain(const GmshMesh& mesh) {
  const auto touching = incidence(mesh);
  std::vector<bool> used(mesh.lines.size(), false);
  std::vector<Loop> loops;
  for (std::size_t start = 0; start < mesh.lines.size(); ++start) {
    if (used[start])
      continue;
    Loop loop;
    std::vector<Tag> tags;
    std::size_t line = start;
    Tag node = mesh.lines[start].from;
    while (!used[line]) {
      used[line] = true;
      tags.push_back(node);
      loop.vertices.push_back(mesh.nodes.at(node).place);
      loop.edges.push_back(nameOf(mesh, mesh.lines[line].group));
      loop.bulges.push_back(bulgeOf(mesh, mesh.lines[line], node));
      node = mesh.lines[line].from == node ? mesh.lines[line].to : mesh.lines[line].from;
      const auto& both = touching.at(node);
      line = both[0] == line ? both[1] : both[0];
    }
    if (twiceArea(loop) < 0)
      reverse(loop, tags);
    loops.push_back(merged(loop, tags));
  }
  return loops;
}

}  // namespace

bem::Loops readGmsh(const std::string& text) {
  const GmshMesh mesh = readGmshMesh(text);
  std::vector<Loop> loops = chain(mesh);
  checkPlane(mesh);
  for (const Loop& loop : loops)
    if (loop.vertices.size() < (loop.bulges.empty() ? 3 : 2))
      throw InputError("a loop of lines has no area");
  const auto area = [](Loop loop) {
    loop.bulges.resize(loop.vertices.size());
    return twiceArea(loop);
  };
  const auto outer =
      std::max_element(loops.begin(), loops.end(),
                       [&](const Loop& a, const Loop& b) { return area(a) < area(b); });
  bem::Loops result{*outer, {}};
  loops.erase(outer);
  result.holes = std::move(loops);
  return result;
}

}  // namespace epafi::drivers
