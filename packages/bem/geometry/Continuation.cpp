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

/// The image of a curve behind a line, so that the body lies to its left.
Curve mirrored(const Curve& curve, const Curve& line) {
  const Vec2 along = line.tangent(0);
  const auto image = [&](Vec2 x) {
    const Vec2 off = x - line.from();
    return line.from() + 2 * dot(off, along) * along - off;
  };
  return {image(curve.to()), image(curve.from()), std::tan(0.25 * curve.angle())};
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
  bool hasImage = false;
  for (int e = 0; e < count; ++e)
    hasImage = hasImage || outline.isMirror(e);
  for (Continuations& beyond : result)
    beyond.turns = !hasImage;
  // once more around each line for what goes on across its first vertex
  for (int k = 0; k < 2 * count; ++k) {
    const int e = k % count;
    const int previous = edges[e].previous;
    const Curve& own = edges[e].curve;
    const bool isImage = outline.isMirror(previous);
    const Curve behind =
        isImage ? mirrored(own, edges[previous].curve) : edges[previous].curve;
    result[e].before =
        across(behind, own, behind, isImage ? result[e].after : result[previous].before);
    const int from = count - 1 - e;
    const int next = edges[from].next;
    const Curve& last = edges[from].curve;
    const bool goesOnAsImage = outline.isMirror(next);
    const Curve ahead =
        goesOnAsImage ? mirrored(last, edges[next].curve) : edges[next].curve;
    result[from].after = across(last, ahead, ahead,
                                goesOnAsImage ? result[from].before : result[next].after);
  }
  return result;
}

}  // namespace epafi::bem
