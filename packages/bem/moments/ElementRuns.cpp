#include "bem/moments/ElementRuns.hpp"

#include "bem/base/Box.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::bem {

namespace {

ElementLanes makeRun(const Mesh& mesh, int first) {
  ElementLanes run;
  run.first = run.last = first;
  while (run.last < first + lanes && !run.closesLoop) {
    const int next = mesh[run.last].next;
    ++run.last;
    run.closesLoop = next != run.last;
  }
  Box box;
  for (int lane = 0; lane < lanes; ++lane) {
    const int f = first + lane;
    if (f >= run.last) {
      run.drop(lane);
      continue;
    }
    const Element& element = mesh[f];
    run.set(lane, element.curve.frame().middle, element);
    run.largestHalf = std::max(run.largestHalf, element.half);
    run.largestAngle = std::max(run.largestAngle, std::abs(element.curve.angle()));
    run.degree = std::max(run.degree, element.degree);
    run.densities = std::max(run.densities, element.densities);
    box.add(element.curve.frame().middle);
  }
  run.centre = box.middle();
  for (int f = first; f < run.last; ++f) {
    const Vec2 offset = mesh[f].curve.frame().middle - run.centre;
    run.radius = std::max(run.radius, length(offset) + mesh[f].half);
  }
  return run;
}

}  // namespace

ElementRuns::ElementRuns(const Mesh& mesh) : mesh_(&mesh) {
  int loops = 0;
  while (runs_.empty() || runs_.back().last < mesh.size()) {
    runs_.push_back(makeRun(mesh, runs_.empty() ? 0 : runs_.back().last));
    runs_.back().loop = loops;
    loops += runs_.back().closesLoop ? 1 : 0;
    runOf_.resize(static_cast<std::size_t>(runs_.back().last), size() - 1);
  }
}

ElementLanes ElementRuns::choose(int e, int r, const ElementRange& wanted,
                                 int largestOuter) const {
  const ElementLanes& run = (*this)[r];
  ElementLanes result = run;
  const bool all = wanted.first <= run.first && run.last <= wanted.last;
  if (all && chooseAtOnce(e, result))
    return result;
  for (int lane = 0; lane < lanes; ++lane) {
    const int f = run.first + lane;
    result.drop(lane);
    if (f >= run.last || !wanted.contain(f))
      continue;
    const Vec2 w = mesh_->offset(e, f);
    const Nearness order = nearness(*mesh_, e, f, w);
    if (!order.isFar() || order.outer > largestOuter)
      continue;
    result.set(lane, w, (*mesh_)[f]);
    result.own[lane] = order;
    result.smooth.include(order);
  }
  return result;
}

// |w| between middles is at least the distance to the circle plus half of the element,
// and a bound for the sums of focal distances, see nearness.
bool ElementRuns::chooseAtOnce(int e, ElementLanes& run) const {
  const Element& x = (*mesh_)[e];
  const Vec2 toCentre = x.curve.frame().middle - run.centre;
  const double gap = length(toCentre) - run.radius;
  const double zE = gap / x.half;
  const double zF = (gap - x.half) / run.largestHalf;
  constexpr double ofRounding =
      1e-12;  // less is not known to the digits that matter here
  if (gap < ofRounding || gap - x.half < std::max(x.half, run.largestHalf) ||
      std::min(zE, zF) < zOfCircles)
    return false;
  const Nearness smooth{farOrder(x.curve.angle(), zE), farOrder(run.largestAngle, zF)};
  if (std::max(smooth.outer, smooth.inner) > smoothOrderOfCircles)  // arcs'
    return false;
  run.arePlain = gap > Mesh::plainDistance;
  run.smooth = smooth;
  for (int lane = 0; lane < run.last - run.first; ++lane) {
    const Vec2 w = run.arePlain
                       ? x.curve.frame().middle - Vec2{run.wx[lane], run.wy[lane]}
                       : mesh_->offset(e, run.first + lane);
    run.wx[lane] = w.x;
    run.wy[lane] = w.y;
    run.own[lane] = smooth;
  }
  return true;
}

}  // namespace epafi::bem
