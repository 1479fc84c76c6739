#include "bem/geometry/Continuation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace epafi::bem {

namespace {

/// Beyond the common end of two curves, of which `other` lies there and goes on as `further`.
Continuation across(const Curve& arriving, const Curve& leaving, const Curve& other,
                    const Continuation& further) {
  if (!joinSmoothly(arriving, leaving))
    return {0, cross(arriving.tangent(1), leaving.tangent(-1)) > 0
                   ? std::numeric_limits<double>::infinity()
                   : 0};
  if (!haveOneCurvature(arriving, leaving))
    return {0, std::max(other.curvature(), 0.0)};
  return {other.length() + further.length, further.curvature};
}

}  // namespace

bool haveOneCurvature(const Curve& a, const Curve& b) {
  constexpr double oneCircle = 1e-9;
  return std::abs(a.curvature() - b.curvature()) <=
         oneCircle * std::abs(a.curvature() + b.curvature());
}

std::vector<Continuations> continuations(const Outline& outline) {
  const std::vector<Edge>& edges = outline.edges();
  const auto count = static_cast<int>(edges.size());
  std::vector<Continuations> result(edges.size());
  // once more around each line for what goes on across its first vertex
  for (int k = 0; k < 2 * count; ++k) {
    const int e = k % count;
    const int previous = edges[e].previous;
    const Curve& behind = edges[previous].curve;
    result[e].before = across(behind, edges[e].curve, behind, result[previous].before);
    const int from = count - 1 - e;
    const int next = edges[from].next;
    const Curve& ahead = edges[next].curve;
    result[from].after = across(edges[from].curve, ahead, ahead, result[next].after);
  }
  return result;
}

}  // namespace epafi::bem
