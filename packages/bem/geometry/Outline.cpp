#include "bem/geometry/Outline.hpp"

#include "bem/base/Error.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::bem {

namespace {

std::size_t after(std::size_t i, const Loop& loop) {
  return (i + 1) % loop.vertices.size();
}

std::string nameOf(const Loop& loop, std::size_t edge) {
  return message("edge ", edge, " ('", loop.edges[edge], "')");
}

std::string pointText(Vec2 p) { return message("(", p.x, ", ", p.y, ")"); }

double distance(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 along = b - a;
  const double t = std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
  return norm(p - (a + t * along));
}

bool properlyCross(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const auto opposite = [](double s, double t) {
    return (s < 0 && t > 0) || (s > 0 && t < 0);
  };
  return opposite(cross(b - a, c - a), cross(b - a, d - a)) &&
         opposite(cross(d - c, a - c), cross(d - c, b - c));
}

/// Smallest distance of two segments; 0 where they cross.
double distance(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  if (properlyCross(a, b, c, d))
    return 0;
  return std::min(
      {distance(a, c, d), distance(b, c, d), distance(c, a, b), distance(d, a, b)});
}

/// Closer than this share of the outline's size, two places count as one: below it the
/// difference of two coordinates has no correct digit left.
constexpr double resolution = 1e-13;

double sizeOf(const Loop& loop) {
  double size = 0;
  for (Vec2 a : loop.vertices)
    for (Vec2 b : loop.vertices)
      size = std::max(size, norm(a - b));
  return size;
}

/// How well coordinates tell places apart, digits lost to a distant origin included.
double resolutionOf(const Loop& loop) {
  double largest = sizeOf(loop);
  for (Vec2 v : loop.vertices)
    largest = std::max({largest, std::abs(v.x), std::abs(v.y)});
  return resolution * largest;
}

/// Twice the signed area, about the first vertex: no digits lost far from the origin.
double twiceArea(const Loop& loop) {
  double area = 0;
  for (std::size_t i = 0; i < loop.vertices.size(); ++i)
    area += cross(loop.vertices[i] - loop.vertices[0],
                  loop.vertices[after(i, loop)] - loop.vertices[0]);
  return area;
}

void checkVertices(const Loop& loop) {
  if (loop.vertices.size() < 3)
    throw InputError(message("a polygon needs at least 3 vertices, this one has ",
                             loop.vertices.size()));
  if (loop.edges.size() != loop.vertices.size())
    throw InputError(message("a polygon of ", loop.vertices.size(),
                             " vertices has as many ", "edges; ", loop.edges.size(),
                             " names are given"));
  for (std::size_t i = 0; i < loop.vertices.size(); ++i)
    if (!std::isfinite(loop.vertices[i].x) || !std::isfinite(loop.vertices[i].y))
      throw InputError(
          message("vertex ", i, " = ", pointText(loop.vertices[i]), " is not finite"));
}

/// Neighbours share a vertex, so what they must not do is fold back onto each other.
void checkFold(const Loop& loop, std::size_t i, double tolerance) {
  const std::size_t j = after(i, loop);
  const Vec2 a = loop.vertices[i];
  const Vec2 corner = loop.vertices[j];
  const Vec2 b = loop.vertices[after(j, loop)];
  if (dot(a - corner, b - corner) > 0 &&
      std::min(distance(a, corner, b), distance(b, corner, a)) <= tolerance)
    throw InputError(message(nameOf(loop, j), " runs back along ", nameOf(loop, i)));
}

void checkSimple(const Loop& loop) {
  const double tolerance = resolutionOf(loop);
  const std::size_t n = loop.vertices.size();
  const auto& v = loop.vertices;
  for (std::size_t i = 0; i < n; ++i)
    if (!(norm(v[after(i, loop)] - v[i]) > tolerance))
      throw InputError(message(nameOf(loop, i), " has no length: vertices ", i, " and ",
                               after(i, loop), " are both ", pointText(v[i]),
                               i + 1 == n
                                   ? "; the polygon closes by itself, do not repeat "
                                     "the first vertex"
                                   : ""));
  for (std::size_t i = 0; i < n; ++i) {
    checkFold(loop, i, tolerance);
    for (std::size_t j = i + 2; j < n; ++j)
      if (!(i == 0 && j == n - 1) &&
          distance(v[i], v[i + 1], v[j], v[after(j, loop)]) <= tolerance)
        throw InputError(message("the polygon touches or crosses itself: ",
                                 nameOf(loop, i), " and ", nameOf(loop, j)));
  }
  if (!(twiceArea(loop) > 0))
    throw InputError(
        "the polygon runs clockwise; list its vertices counter-clockwise (holes too)");
}

/// Crossing number of a ray to the right.
bool inside(Vec2 p, const std::vector<Vec2>& polygon) {
  bool odd = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2 a = polygon[i];
    const Vec2 b = polygon[j];
    if ((a.y > p.y) != (b.y > p.y)) {
      const double side = cross(b - a, p - a);
      if (b.y > a.y ? side > 0 : side < 0)
        odd = !odd;
    }
  }
  return odd;
}

void checkApart(const Loop& a, const Loop& b, double tolerance, const std::string& first,
                const std::string& second) {
  for (std::size_t i = 0; i < a.vertices.size(); ++i)
    for (std::size_t j = 0; j < b.vertices.size(); ++j)
      if (distance(a.vertices[i], a.vertices[after(i, a)], b.vertices[j],
                   b.vertices[after(j, b)]) <= tolerance)
        throw InputError(message(first, " and ", second, " touch or cross: ",
                                 nameOf(a, i), " and ", nameOf(b, j)));
}

void checkLoop(const Loop& loop, const std::string& name) {
  try {
    checkVertices(loop);
    checkSimple(loop);
  } catch (const InputError& error) {
    throw InputError(name + ": " + error.what());
  }
}

/// The same polygon clockwise.  It starts at the last vertex, so its first edge is the
/// user's last but one, which leads there; the user's last edge comes last again.
Loop reversed(const Loop& loop) {
  Loop result{{loop.vertices.rbegin(), loop.vertices.rend()},
              {loop.edges.rbegin() + 1, loop.edges.rend()}};
  result.edges.push_back(loop.edges.back());
  return result;
}

}  // namespace

Scaling scalingOf(const Loop& outer) {
  Scaling scaling;
  if (outer.vertices.empty())
    return scaling;
  scaling.length = sizeOf(outer);
  Vec2 low = outer.vertices[0];
  Vec2 high = low;
  for (Vec2 v : outer.vertices) {
    low = {std::min(low.x, v.x), std::min(low.y, v.y)};
    high = {std::max(high.x, v.x), std::max(high.y, v.y)};
  }
  scaling.origin = 0.5 * (low + high);
  return scaling;
}

Outline::Outline(const Loop& outer, const std::vector<Loop>& holes,
                 const Scaling& scaling)
    : scaling_(scaling) {
  checkLoop(outer, "outer polygon");
  const double tolerance = resolutionOf(outer);
  for (std::size_t k = 0; k < holes.size(); ++k) {
    const std::string name = message("hole ", k + 1);
    checkLoop(holes[k], name);
    checkApart(outer, holes[k], tolerance, "the outer polygon", name);
    if (!inside(holes[k].vertices[0], outer.vertices))
      throw InputError(name + " does not lie inside the outer polygon");
    for (std::size_t other = 0; other < k; ++other) {
      const std::string otherName = message("hole ", other + 1);
      checkApart(holes[other], holes[k], tolerance, otherName, name);
      if (inside(holes[k].vertices[0], holes[other].vertices) ||
          inside(holes[other].vertices[0], holes[k].vertices))
        throw InputError(message(name, " and ", otherName, " lie inside each other"));
    }
  }

  diameter_ = sizeOf(outer);
  if (!(diameter_ <= scaling.length))
    throw InputError(message("a body of diameter ", diameter_,
                             " in a scaling for lengths up to ", scaling.length));

  const auto append = [this](const Loop& loop) {
    const int first = static_cast<int>(edges_.size());
    const int n = static_cast<int>(loop.vertices.size());
    for (int i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      Edge edge;
      const Vec2 from = loop.vertices[k];
      const Vec2 to = loop.vertices[after(k, loop)];
      // The chord from the user's own coordinates: the shift to the origin rounds.
      edge.curve =
          Curve(scaled(from), scaled(to), (1 / scaling_.length) * (to - from), 0);
      edge.loop = loops_;
      edge.previous = first + (i + n - 1) % n;
      edge.next = first + (i + 1) % n;
      edge.boundary = loop.edges[k];
      edges_.push_back(edge);
    }
    ++loops_;
  };
  append(outer);
  for (const Loop& hole : holes)
    append(reversed(hole));
}

bool Outline::contains(Vec2 physical) const {
  const Vec2 p = scaled(physical);
  for (const Edge& edge : edges_)
    if (edge.curve.contains(p, resolution))
      return false;
  bool odd = false;
  for (int loop = 0; loop < loops_; ++loop) {
    std::vector<Vec2> polygon;
    for (const Edge& edge : edges_)
      if (edge.loop == loop)
        polygon.push_back(edge.curve.from());
    if (inside(p, polygon))
      odd = !odd;
  }
  return odd;
}

}  // namespace epafi::bem
