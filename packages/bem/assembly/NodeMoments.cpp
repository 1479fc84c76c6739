#include "bem/assembly/NodeMoments.hpp"

#include "bem/potential/RelativeTarget.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace epafi::bem {

namespace {

void addClosedForm(const Element& source, const RelativeTarget& target, std::size_t first,
                   NodeMoments& result) {
  const Complex tangent(source.tangent.x, source.tangent.y);
  const Complex square = tangent * tangent;
  const bool atStart = target.zPlus1 == 0.0;
  const bool atEnd = target.zMinus1 == 0.0;
  LegendreMoments m;
  if (!atStart && !atEnd)
    evaluateMoments(target, source.degree - 1, Need::CandL, m);
  for (int j = 0; j < source.degree; ++j) {
    const double constant = j == 0 ? 2 : 0;
    double l = 0;
    Complex bc = 0;          // b C_j -> 0 at the ends
    if (atStart || atEnd) {  // limits of the closed form
      const double limit = j == 0 ? 2 * std::log(2.0) - 2 : -2.0 / (j * (j + 1.0));
      l = atStart && j % 2 == 1 ? -limit : limit;
    } else {
      l = m.l[j];
      bc = target.b() * m.c[j];
    }
    const std::size_t at = first + static_cast<std::size_t>(j);
    result.log[at] = l + constant * std::log(source.half);
    result.phase[at] = square * (constant - Complex(0, 2) * bc);
  }
}

/// A point as an element without length: one Gauss point, of weight 2.
constexpr int pointOrder = 1;

void addLane(const FarMoments& far, int lane, const Element& source, std::size_t first,
             NodeMoments& result) {
  const Complex tangent(source.tangent.x, source.tangent.y);
  const Complex square = tangent * tangent;
  for (int j = 0; j < source.degree; ++j) {
    const std::size_t at = first + static_cast<std::size_t>(j);
    result.log[at] = 0.5 * far.log[j][lane];
    // w/conj(w) = τ² (1 - 2 (w·n)²/r² - 2i (w·n)(w·τ)/r²)
    result.phase[at] =
        square * Complex((j == 0 ? 2 : 0) - far.across[j][lane], -far.along[j][lane]);
  }
}

}  // namespace

NodeMoments nodeMoments(const Mesh& mesh, const BoundaryPoint& x,
                        const std::vector<int>& sources) {
  std::vector<std::size_t> start(1, 0);
  for (const int f : sources)
    start.push_back(start.back() + static_cast<std::size_t>(mesh[f].degree));
  NodeMoments result{Vector(start.back()), std::vector<Complex>(start.back())};
  Element point;
  point.tangent = {1, 0};
  point.normal = {0, -1};
  const auto far = std::make_unique<FarMoments>();
  for (std::size_t first = 0; first < sources.size(); first += lanes) {
    FarBatch batch{};
    int inner = 0;
    int columns = 0;
    std::size_t chosen[lanes];
    int count = 0;
    const std::size_t last = std::min(first + lanes, sources.size());
    for (std::size_t s = first; s < last; ++s) {
      const int f = sources[s];
      const Vec2 w = mesh.difference(x, mesh.at(f, 0));
      int order = 0;
      if (isNear(w, mesh[f], order)) {
        addClosedForm(mesh[f], seenFrom(mesh, f, x), start[s], result);
        continue;
      }
      batch.set(count, w, mesh[f]);
      chosen[count++] = s;
      inner = std::max(inner, order);
      columns = std::max(columns, mesh[f].degree);
    }
    if (count == 0)
      continue;
    for (int lane = count; lane < lanes; ++lane)
      batch.drop(lane);
    farMoments(point, batch, 1, columns, {pointOrder, inner}, *far);
    for (int lane = 0; lane < count; ++lane)
      addLane(*far, lane, mesh[sources[chosen[lane]]], start[chosen[lane]], result);
  }
  return result;
}

}  // namespace epafi::bem
