#include "bem/geometry/Outline.hpp"

#include "bem/base/Box.hpp"
#include "bem/base/Error.hpp"
#include "bem/geometry/Crossing.hpp"

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

CurveTree curvesOf(const Loop& loop) {
  std::vector<Curve> curves;
  for (std::size_t i = 0; i < loop.vertices.size(); ++i)
    curves.push_back(loop.curve(i));
  return CurveTree(std::move(curves));
}

bool hasArcs(const Loop& loop) {
  return std::any_of(loop.bulges.begin(), loop.bulges.end(),
                     [](double bulge) { return bulge != 0; });
}

/// Points that tell how large a polygon is.
std::vector<Vec2> extent(const Loop& loop) {
  if (!hasArcs(loop))
    return loop.vertices;
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < loop.vertices.size(); ++i)
    for (const Vec2 point : extent(loop.curve(i)))
      points.push_back(point);
  return points;
}

/// Closer than this share of the outline's size, two places count as one: below it the
/// difference of two coordinates has no correct digit left.
constexpr double resolution = 1e-13;

Box boxOf(const std::vector<Vec2>& points) {
  Box box;
  for (const Vec2 point : points)
    box.add(point);
  return box;
}

/// The diameter, but for rounding; from the points farthest from the middle on, since others
/// cannot be farther apart.  What is not finite is left to those who say so.
double sizeOf(const Loop& loop) {
  std::vector<Vec2> points = extent(loop);
  const Vec2 middle = boxOf(points).middle();
  const auto reach = [middle](Vec2 v) { return norm(v - middle); };
  const auto isNowhere = [&](Vec2 v) { return !std::isfinite(reach(v)); };
  points.erase(std::remove_if(points.begin(), points.end(), isNowhere), points.end());
  std::sort(points.begin(), points.end(),
            [&](Vec2 a, Vec2 b) { return reach(a) > reach(b); });
  double size = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      if (reach(points[i]) + reach(points[j]) <= size)
        break;
      size = std::max(size, norm(points[i] - points[j]));
    }
  return size;
}

/// How well coordinates tell places apart, digits lost to a distant origin included.
double resolutionOf(const Loop& loop, double size) {
  double largest = size;
  for (Vec2 v : extent(loop))
    largest = std::max({largest, std::abs(v.x), std::abs(v.y)});
  return resolution * largest;
}

/// Closer to a common vertex than this share of the outline's size edges are not asked
/// whether they touch: smooth joints do.
constexpr double blindness = 1e-6;

/// An arc of 337 degrees: nearly all of a circle.
constexpr double largestBulge = 10;

/// Twice the signed area between the chords, about the first vertex.
double twiceAreaOfChords(const Loop& loop) {
  double area = 0;
  for (std::size_t i = 0; i < loop.vertices.size(); ++i)
    area += cross(loop.vertices[i] - loop.vertices[0],
                  loop.vertices[after(i, loop)] - loop.vertices[0]);
  return area;
}

bool bulgesFit(const Loop& loop) {
  return loop.bulges.empty() || loop.bulges.size() == loop.vertices.size();
}

void checkBulges(const Loop& loop) {
  if (!bulgesFit(loop))
    throw InputError("a polygon of ", loop.vertices.size(),
                     " vertices has as many bulges, one for each edge (0: straight); ",
                     loop.bulges.size(), " are given");
  for (std::size_t i = 0; i < loop.bulges.size(); ++i)
    if (!(std::abs(loop.bulges[i]) <= largestBulge))
      throw InputError("the bulge of edge ", i, " is ", loop.bulges[i],
                       "; it is tan(angle/4) of the arc, and from -", largestBulge,
                       " to ", largestBulge, " (1: half a circle)");
}

void checkVertices(const Loop& loop) {
  const std::size_t least = hasArcs(loop) ? 2 : 3;
  if (loop.vertices.size() < least)
    throw InputError("a polygon needs at least ", least, " vertices, this one has ",
                     loop.vertices.size());
  if (loop.edges.size() != loop.vertices.size())
    throw InputError("a polygon of ", loop.vertices.size(), " vertices has as many ",
                     "edges; ", loop.edges.size(), " names are given");
  for (std::size_t i = 0; i < loop.vertices.size(); ++i)
    if (!std::isfinite(loop.vertices[i].x) || !std::isfinite(loop.vertices[i].y))
      throw InputError("vertex ", i, " = ", pointText(loop.vertices[i]),
                       " is not finite");
}

[[noreturn]] void failToBeSimple(const Loop& loop, std::size_t i, std::size_t j) {
  // the arcs of a clockwise circle bulge inwards
  throw InputError(
      "the polygon touches or crosses itself: ", nameOf(loop, i), " and ",
      nameOf(loop, j),
      hasArcs(loop) && twiceAreaOfChords(loop) < 0
          ? "; its vertices run clockwise, list them counter-clockwise"
          : "; where faces of a crack coincide, cut the body along the crack "
            "and tie its parts ahead of it");
}

/// Neighbours share a vertex, so what they must not do is fold back onto each other.
void checkFold(const Loop& loop, std::size_t i, double tolerance, double size) {
  const std::size_t j = after(i, loop);
  const Curve first = loop.curve(i);
  const Curve second = loop.curve(j);
  if (!first.isStraight() || !second.isStraight()) {
    if (meetElsewhere(first, second, tolerance, blindness * size))
      failToBeSimple(loop, i, j);
    return;
  }
  const Vec2 corner = first.to();
  if (dot(first.from() - corner, second.to() - corner) > 0 &&
      std::min(second.distance(first.from()), first.distance(second.to())) <= tolerance)
    throw InputError(nameOf(loop, j), " runs back along ", nameOf(loop, i));
}

void checkSimple(const Loop& loop) {
  const double size = sizeOf(loop);
  const double tolerance = resolutionOf(loop, size);
  const std::size_t n = loop.vertices.size();
  const auto& v = loop.vertices;
  for (std::size_t i = 0; i < n; ++i)
    if (!(norm(v[after(i, loop)] - v[i]) > tolerance))
      throw InputError(
          nameOf(loop, i), " has no length: vertices ", i, " and ", after(i, loop),
          " are both ", pointText(v[i]),
          i + 1 == n ? "; the polygon closes by itself, do not repeat the first vertex"
                     : "");
  const CurveTree tree = curvesOf(loop);
  for (std::size_t i = 0; i < n; ++i) {
    checkFold(loop, i, tolerance, size);
    const Curve& curve = tree.curves()[i];
    tree.search([&](const Disc& disc) { return disc.isNear(discOf(curve), tolerance); },
                [&](std::size_t j) {
                  if (j >= i + 2 && !(i == 0 && j == n - 1) &&
                      meet(curve, tree.curves()[j], tolerance))
                    failToBeSimple(loop, i, j);
                });
  }
  const double area = loop.twiceArea();
  if (!std::isnormal(area))
    throw InputError("the polygon's area cannot be computed from coordinates of this ",
                     "size; write them in another unit of length");
  if (area < 0)
    throw InputError(
        "the polygon runs clockwise; list its vertices counter-clockwise (holes too)");
}

void checkApart(const Loop& a, const Loop& b, double tolerance, const std::string& first,
                const std::string& second) {
  const CurveTree ofB = curvesOf(b);
  for (std::size_t i = 0; i < a.vertices.size(); ++i) {
    const Curve curve = a.curve(i);
    ofB.search([&](const Disc& disc) { return disc.isNear(discOf(curve), tolerance); },
               [&](std::size_t j) {
                 if (meet(curve, ofB.curves()[j], tolerance))
                   throw InputError(first, " and ", second,
                                    " touch or cross: ", nameOf(a, i), " and ",
                                    nameOf(b, j));
               });
  }
}

void checkLoop(const Loop& loop, const std::string& name) {
  try {
    checkVertices(loop);
    checkBulges(loop);
    checkSimple(loop);
  } catch (const InputError& error) {
    throw InputError(name + ": " + error.what());
  }
}

/// The same polygon clockwise.  It starts at the last vertex, so its first edge is the
/// user's last but one, which leads there; the user's last edge comes last again.  What
/// bulged to the right does so to the left.
Loop reversed(const Loop& loop) {
  Loop result{{loop.vertices.rbegin(), loop.vertices.rend()},
              {loop.edges.rbegin() + 1, loop.edges.rend()}};
  result.edges.push_back(loop.edges.back());
  if (loop.bulges.empty())
    return result;
  result.bulges.assign(loop.bulges.rbegin() + 1, loop.bulges.rend());
  result.bulges.push_back(loop.bulges.back());
  for (double& bulge : result.bulges)
    bulge = -bulge;
  return result;
}

}  // namespace

Curve Loop::curve(std::size_t edge) const {
  return {vertices[edge], vertices[after(edge, *this)],
          bulges.empty() ? 0 : bulges[edge]};
}

double Loop::twiceArea() const {
  double area = twiceAreaOfChords(*this);
  if (hasArcs(*this))
    for (std::size_t i = 0; i < vertices.size(); ++i)
      area += twiceAreaBesideChord(curve(i));
  return area;
}

Scaling scalingOf(const Loop& outer, bool isAxisymmetric) {
  Scaling scaling;
  scaling.isAxisymmetric = isAxisymmetric;
  if (outer.vertices.empty() || !bulgesFit(outer))  // Outline says so
    return scaling;
  scaling.length = sizeOf(outer);
  scaling.origin = boxOf(extent(outer)).middle();
  if (isAxisymmetric)
    scaling.origin.x = 0;
  return scaling;
}

Outline::Outline(const Loop& outer, const std::vector<Loop>& holes,
                 const Scaling& scaling)
    : scaling_(scaling) {
  checkLoop(outer, "outer polygon");
  diameter_ = sizeOf(outer);
  const double tolerance = resolutionOf(outer, diameter_);
  for (std::size_t k = 0; k < holes.size(); ++k) {
    const std::string name = message("hole ", k + 1);
    checkLoop(holes[k], name);
    checkApart(outer, holes[k], tolerance, "the outer polygon", name);
    if (!inside(holes[k].vertices[0], curvesOf(outer)))
      throw InputError(name + " does not lie inside the outer polygon");
    for (std::size_t other = 0; other < k; ++other) {
      const std::string otherName = message("hole ", other + 1);
      checkApart(holes[other], holes[k], tolerance, otherName, name);
      if (inside(holes[k].vertices[0], curvesOf(holes[other])) ||
          inside(holes[other].vertices[0], curvesOf(holes[k])))
        throw InputError(name, " and ", otherName, " lie inside each other");
    }
  }

  if (!(diameter_ <= scaling.length))
    throw InputError("a body of diameter ", diameter_, " in a scaling for lengths up to ",
                     scaling.length);

  const auto append = [this](const Loop& loop) {
    const int first = static_cast<int>(edges_.size());
    const int n = static_cast<int>(loop.vertices.size());
    for (int i = 0; i < n; ++i) {
      const std::size_t k = i;
      Edge edge;
      const Vec2 from = loop.vertices[k];
      const Vec2 to = loop.vertices[after(k, loop)];
      // The chord from the user's own coordinates: the shift to the origin rounds.
      edge.curve = Curve(scaled(from), scaled(to), (1 / scaling_.length) * (to - from),
                         loop.bulges.empty() ? 0 : loop.bulges[k]);
      edge.start = from;
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
  std::vector<Curve> curves;
  for (const Edge& edge : edges_)
    curves.push_back(edge.curve);
  curves_ = CurveTree(std::move(curves));
}

bool Outline::contains(Vec2 physical) const {
  const Vec2 p = scaled(physical);
  bool isOnBoundary = false;
  curves_.search(
      [&](const Disc& disc) {
        return disc.isNear({p, 0}, resolution);
      },
      [&](std::size_t k) {
        isOnBoundary = isOnBoundary || curves_.curves()[k].contains(p, resolution);
      });
  return !isOnBoundary && inside(p, curves_);
}

}  // namespace epafi::bem
