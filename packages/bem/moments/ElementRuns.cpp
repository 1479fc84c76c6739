#include "bem/moments/ElementRuns.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::bem {

namespace {

ElementRun makeRun(const Mesh& mesh, int first) {
  ElementRun run;
  run.first = run.last = first;
  while (run.last < first + lanes && !run.closesLoop) {
    const int next = mesh[run.last].next;
    ++run.last;
    run.closesLoop = next != run.last;
  }
  Vec2 low = mesh[first].curve.frame().middle;
  Vec2 high = low;
  for (int lane = 0; lane < lanes; ++lane) {
    const int f = first + lane;
    if (f >= run.last) {
      run.elements.drop(lane);
      continue;
    }
    const Element& element = mesh[f];
    run.elements.set(lane, element.curve.frame().middle, element);
    run.largestHalf = std::max(run.largestHalf, element.half);
    run.angle = std::max(run.angle, std::abs(element.curve.angle()));
    run.degree = std::max(run.degree, element.degree);
    run.densities = std::max(run.densities, element.densities);
    low = {std::min(low.x, element.curve.frame().middle.x),
           std::min(low.y, element.curve.frame().middle.y)};
    high = {std::max(high.x, element.curve.frame().middle.x),
            std::max(high.y, element.curve.frame().middle.y)};
  }
  run.centre = 0.5 * (low + high);
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

FarLanes ElementRuns::choose(int e, int r, const ElementRange& wanted, FarBatch& batch,
                             int largestOuter) const {
  const ElementRun& run = (*this)[r];
  FarLanes result;
  const bool all = wanted.first <= run.first && run.last <= wanted.last;
  if (all && chooseAtOnce(e, run, result, batch))
    return result;
  for (int lane = 0; lane < lanes; ++lane) {
    const int f = run.first + lane;
    batch.drop(lane);
    if (f >= run.last || !wanted.contain(f))
      continue;
    FarOrder order;
    const Vec2 w = mesh_->offset(e, f);
    const Element& source = (*mesh_)[f];
    result.far[lane] = !isNear(*mesh_, e, f, w, order) && order.outer <= largestOuter;
    if (!result.far[lane])
      continue;
    batch.set(lane, w, source);
    result.own[lane] = order;
    ++result.count;
    result.columns = std::max(result.columns, source.degree);
    result.smooth = {std::max(result.smooth.outer, order.outer),
                     std::max(result.smooth.inner, order.inner)};
  }
  return result;
}

// |w| between middles is at least the distance to the circle plus half of the element,
// and a bound for the sums of focal distances, see isNear.
bool ElementRuns::chooseAtOnce(int e, const ElementRun& run, FarLanes& result,
                               FarBatch& batch) const {
  const Element& x = (*mesh_)[e];
  const Vec2 toCentre = x.curve.frame().middle - run.centre;
  const double gap = length(toCentre) - run.radius;
  const double zE = gap / x.half;
  const double zF = (gap - x.half) / run.largestHalf;
  const bool isFar =
      gap > Mesh::plainDistance && gap - x.half > std::max(x.half, run.largestHalf);
  if (!isFar || std::min(zE, zF) < zOfCircles)
    return false;
  result.smooth = {farOrder(x.curve.angle(), zE), farOrder(run.angle, zF)};
  if (std::max(result.smooth.outer, result.smooth.inner) > smoothOrderOfCircles) {
    result.smooth = {};  // arcs'
    return false;
  }
  result.atOnce = true;
  result.columns = run.degree;
  result.count = run.last - run.first;
  std::fill_n(result.far, result.count, true);
  batch = run.elements;
  for (int lane = 0; lane < result.count; ++lane) {
    batch.wx[lane] = x.curve.frame().middle.x - run.elements.wx[lane];
    batch.wy[lane] = x.curve.frame().middle.y - run.elements.wy[lane];
  }
  return true;
}

}  // namespace epafi::bem
