#include "bem/base/Error.hpp"
#include "drivers/scene/Readers.hpp"

#include <Teuchos_Array.hpp>

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <numeric>

namespace epafi::drivers {

namespace {

using bem::InputError;
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
                     " numbers, but the polygon has ", edges, " edges");
  return counts.toVector();
}

/// Converts the user's order on a hole to that of Outline: last but one, ..., 0, last.
std::vector<int> alongHole(const std::vector<int>& counts) {
  std::vector<int> result(counts.rbegin() + 1, counts.rend());
  result.push_back(counts.back());
  return result;
}

std::vector<int> countsFromSize(const Part& part, const bem::Outline& outline) {
  const auto size = part.list->get<double>("Mesh Size");
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
    return countsFromSize(part, outline);
  }
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
      Row("Degree", Kind::Whole, "1", {1, 25}, "polynomial degree of the displacement");
  return {
      Row("Elements per Edge", Kind::Counts, "1", bem::from(1),
          "equal elements on each edge of the outer polygon; or give Mesh Size"),
      Row("Hole <k> Elements per Edge", Kind::Counts, "1", bem::from(1),
          "equal elements on each edge of hole k"),
      Row("Mesh Size", Kind::Real, "length", bem::above(0),
          "largest element; each edge gets the smallest number of equal ones"),
      degree != nullptr ? ownDegree.defaultValue(degree) : ownDegree,
  };
}

void readMesh(const Part& own, const Part& discretization, Body& body) {
  const bool sized = own.has("Mesh Size") || own.has("Elements per Edge");
  body.elementsPerEdge = readElements(sized ? own : discretization, *body.outline);
  body.degree = (own.has("Degree") ? own : discretization).list->get<int>("Degree");
}

}  // namespace epafi::drivers
