#include "drivers/scene/OutlineChain.hpp"

#include "bem/base/Error.hpp"
#include "bem/base/Suggestion.hpp"

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
using Tag = NodeTag;

/// Two lines whose directions differ by less than this [radian] are one edge.
constexpr double straight = 1e-9;

/// Two arcs are parts of one circle if their angle [radian] and the relative difference
/// of their curvatures are below this, the accuracy of coordinates with 7 digits.
constexpr double oneCircle = 1e-6;

constexpr const char* severalBodies =
    "; of several bodies in a file Geometry->Boundaries (or, in a mesh, Surface) names "
    "one";

/// The pieces of these boundaries.
void keepOnly(const std::vector<std::string>& boundaries, OutlinePieces& all) {
  std::vector<std::string> names;
  for (const OutlinePiece& piece : all.pieces)
    if (std::find(names.begin(), names.end(), piece.boundary) == names.end())
      names.push_back(piece.boundary);
  for (const std::string& boundary : boundaries)
    if (std::find(names.begin(), names.end(), boundary) == names.end())
      throw InputError("no line is named '", boundary, "'",
                       bem::suggestion(boundary, names));
  const auto isOther = [&](const OutlinePiece& piece) {
    return std::find(boundaries.begin(), boundaries.end(), piece.boundary) ==
           boundaries.end();
  };
  all.pieces.erase(std::remove_if(all.pieces.begin(), all.pieces.end(), isOther),
                   all.pieces.end());
}

/// Makes one node of those that are no farther apart than `same`.
void merge(OutlinePieces& all) {
  std::map<std::pair<double, double>, std::vector<Tag>> cells;  // squares of that width
  std::map<Tag, Tag> ones;
  for (const auto& [tag, place] : all.nodes) {
    const double column = std::floor(place.x / all.same);
    const double row = std::floor(place.y / all.same);
    Tag one = tag;
    for (const double i : {-1.0, 0.0, 1.0})
      for (const double j : {-1.0, 0.0, 1.0})
        if (const auto cell = cells.find({column + i, row + j}); cell != cells.end())
          for (const Tag other : cell->second)
            if (other < one && norm(all.nodes.at(other) - place) <= all.same)
              one = other;
    ones[tag] = one;
    if (one == tag)
      cells[{column, row}].push_back(tag);
  }
  for (OutlinePiece& piece : all.pieces) {
    piece.from = ones.at(piece.from);
    piece.to = ones.at(piece.to);
  }
  all.pieces.erase(
      std::remove_if(all.pieces.begin(), all.pieces.end(),
                     [](const OutlinePiece& piece) { return piece.from == piece.to; }),
      all.pieces.end());
}

/// "; the nearest other end, of 'side', is 0.003 away"
std::string otherEndNear(const OutlinePieces& all, Tag node, const OutlinePiece& piece) {
  std::map<double, std::string> names;  // by distance
  for (const OutlinePiece& other : all.pieces)
    for (const Tag end : {other.from, other.to})
      if (end != piece.from && end != piece.to)
        names[norm(all.nodes.at(end) - all.nodes.at(node))] = other.boundary;
  return names.empty() ? ""
                       : message("; the nearest other end, of '", names.begin()->second,
                                 "', is ", names.begin()->first, " away");
}

/// The pieces at each node; an outline has exactly two.
std::map<Tag, std::vector<std::size_t>> incidence(const OutlinePieces& all) {
  std::map<Tag, std::vector<std::size_t>> result;
  std::set<std::pair<std::pair<Tag, Tag>, double>> pairs;
  for (std::size_t i = 0; i < all.pieces.size(); ++i) {
    const OutlinePiece& piece = all.pieces[i];
    const std::string where = message("line ", piece.fileLine, ": ");
    const double bulge = piece.from < piece.to ? piece.bulge : -piece.bulge;
    if (!pairs.insert({std::minmax(piece.from, piece.to), bulge}).second)
      throw InputError(where, "a second element between nodes ", piece.from, " and ",
                       piece.to, "; an edge has one name", severalBodies);
    result[piece.from].push_back(i);
    result[piece.to].push_back(i);
  }
  for (const auto& [tag, touching] : result)
    if (touching.size() != 2) {
      const Vec2 place = all.nodes.at(tag);
      const OutlinePiece& piece = all.pieces[touching.front()];
      std::string names;
      for (const std::size_t i : touching)
        names += (names.empty() ? "'" : ", '") + all.pieces[i].boundary + "'";
      throw InputError("line ", piece.fileLine, ": at node ", tag, " = (", place.x, ", ",
                       place.y, ") ",
                       touching.size() == 1
                           ? message("the outline ends with ", names,
                                     otherEndNear(all, tag, piece), "; ", all.advice)
                           : message(touching.size(), " lines meet, ", names,
                                     "; an outline has two", severalBodies));
    }
  return result;
}

/// Reverses a loop: edge i leads from vertex i to i+1 again.
void reverse(Loop& loop, std::vector<Tag>& tags) {
  std::reverse(loop.vertices.begin(), loop.vertices.end());
  std::reverse(tags.begin(), tags.end());
  std::reverse(loop.edges.begin(), loop.edges.end() - 1);
  std::reverse(loop.bulges.begin(), loop.bulges.end() - 1);
  for (double& bulge : loop.bulges)
    bulge = -bulge;
}

/// Does the direction, the curvature or the name change at vertex i?
bool isCorner(const Loop& loop, std::size_t i) {
  const std::size_t n = loop.vertices.size();
  const std::size_t before = (i + n - 1) % n;
  if (loop.edges[before] != loop.edges[i])
    return true;
  if (loop.bulges[before] != 0 || loop.bulges[i] != 0) {
    const bem::Curve in = loop.curve(before);
    const bem::Curve out = loop.curve(i);
    return !(dot(in.tangent(1), out.tangent(-1)) > 0 &&
             std::abs(cross(in.tangent(1), out.tangent(-1))) <= oneCircle &&
             std::abs(in.curvature() - out.curvature()) <=
                 oneCircle * std::abs(in.curvature()));
  }
  const Vec2 in = loop.vertices[i] - loop.vertices[before];
  const Vec2 out = loop.vertices[(i + 1) % n] - loop.vertices[i];
  return !(dot(in, out) > 0 &&
           std::abs(cross(in, out)) <= straight * norm(in) * norm(out));
}

/// The loop with its corners only, from the corner with the smallest tag on.
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
  double angle = 0;  // angle of the last edge
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

std::vector<Loop> chain(const OutlinePieces& all) {
  const auto touching = incidence(all);
  std::vector<bool> used(all.pieces.size(), false);
  std::vector<Loop> loops;
  for (std::size_t start = 0; start < all.pieces.size(); ++start) {
    if (used[start])
      continue;
    Loop loop;
    std::vector<Tag> tags;
    std::size_t at = start;
    Tag node = all.pieces[start].from;
    while (!used[at]) {
      const OutlinePiece& piece = all.pieces[at];
      const bool forwards = piece.from == node;
      used[at] = true;
      tags.push_back(node);
      loop.vertices.push_back(all.nodes.at(node));
      loop.edges.push_back(piece.boundary);
      loop.bulges.push_back(forwards ? piece.bulge : -piece.bulge);
      node = forwards ? piece.to : piece.from;
      const auto& both = touching.at(node);
      at = both[0] == at ? both[1] : both[0];
    }
    if (loop.twiceArea() < 0)
      reverse(loop, tags);
    loops.push_back(merged(loop, tags));
  }
  return loops;
}

}  // namespace

bem::Loops chained(OutlinePieces pieces, const FilePart& part) {
  if (!part.boundaries.empty())
    keepOnly(part.boundaries, pieces);
  for (const OutlinePiece& piece : pieces.pieces)
    if (piece.from == piece.to)
      throw InputError("line ", piece.fileLine, ": an element from node ", piece.from,
                       " to itself");
  if (pieces.same > 0)
    merge(pieces);
  for (auto& [tag, place] : pieces.nodes)
    place = part.scale * place;
  std::vector<Loop> loops = chain(pieces);
  if (loops.empty())
    throw InputError("all lines have no length");
  for (const Loop& loop : loops)
    if (loop.vertices.size() < (loop.bulges.empty() ? 3 : 2))
      throw InputError("a loop of lines has no area");
  const auto outer = std::max_element(
      loops.begin(), loops.end(),
      [](const Loop& a, const Loop& b) { return a.twiceArea() < b.twiceArea(); });
  bem::Loops result{*outer, {}};
  loops.erase(outer);
  result.holes = std::move(loops);
  const bem::Outline outline(result.outer);
  const auto isInside = [&](Vec2 place) { return outline.contains(place); };
  for (const Loop& hole : result.holes)
    if (std::none_of(hole.vertices.begin(), hole.vertices.end(), isInside))
      throw InputError("closed lines of '", result.outer.edges[0], "' and '",
                       hole.edges[0], "' are not one inside the other", severalBodies);
  return result;
}

}  // namespace epafi::drivers
