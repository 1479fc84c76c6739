#include "bem/fields/RingGroups.hpp"

#include "bem/algebra/LeastSquares.hpp"
#include "bem/base/Parallel.hpp"
#include "bem/kernel/RingPoints.hpp"
#include "bem/moments/RingCircle.hpp"
#include "bem/simd/Dispatch.hpp"

#include <cmath>

namespace epafi::bem {

namespace {

// In radii of a group: modes of its field that 64 points do not tell apart are 1e-13 of it there.
constexpr double toForces = 1.1;
constexpr double toPlaces = 2.4;
constexpr int forcesAround = 64;
constexpr int placesAround = 80;

/// Of sources.
enum Sums { ofForces = 1, ofDisplacements = 2, ofJumps = 4, withTractions = 8 };

/// Adds what sources do, of each state.
template <int Wanted>
struct Summation {
  const RingLame& lame;
  const RingPointSources& sources;
  const RingTargets& targets;
  std::size_t states;
  AlignedLane* to;

  template <Division How>
  EPAFI_INLINE void run() const {
    const Pack& x = load(targets.x.lane);
    const Pack& y = load(targets.y.lane);
    const Pack& tx = load(targets.tangentX.lane);
    const Pack& ty = load(targets.tangentY.lane);
    for (std::size_t k = 0; k < sources.places.size(); ++k) {
      const double* source = sources.places[k].data();
      RingPoints g;  // NOLINT(cppcoreguidelines-pro-type-member-init)
      g.template evaluate<How>(lame, x - source[0], y - source[1], tx, ty, x, source);
      for (std::size_t state = 0; state < states; ++state) {
        AlignedLane* own = to + 4 * state;
        if constexpr ((Wanted & ofForces) != 0)
          addProducts(-1, sources.forces[k * states + state], g.v, g.t, own);
        if constexpr ((Wanted & ofDisplacements) != 0)
          addProducts(-1, sources.displacements[k * states + state], g.k, g.w, own);
        if constexpr ((Wanted & ofJumps) != 0)
          addProducts(-1, sources.displacements[k * states + state], g.jumpK, g.jumpW,
                      own);
      }
    }
  }

 private:
  EPAFI_INLINE static void addProducts(double sign, const Complex& f,
                                       const Pack (&moves)[4], const Pack (&pulls)[4],
                                       AlignedLane* to) {
    addProduct(sign * f, moves, to);
    if constexpr ((Wanted & withTractions) != 0)
      addProduct(f, pulls, to + 2);
  }
  EPAFI_INLINE static void addProduct(const Complex& f, const Pack (&entries)[4],
                                      AlignedLane* to) {
    bem::add(to[0].lane, f.real() * entries[0] + f.imag() * entries[2]);
    bem::add(to[1].lane, f.real() * entries[1] + f.imag() * entries[3]);
  }
};

/// Displacements n (1 - t²) of a straight piece along the axis.
RingPointSources swellingOf(Vec2 middle, double half) {
  RingPointSources sources;
  const Rule& rule = gaussLegendre(lanes);
  for (std::size_t q = 0; q < rule.points.size(); ++q) {
    const double t = rule.points[q];
    sources.places.push_back({middle.x, middle.y + half * t, 0, 1, middle.x});
    sources.displacements.push_back(half * rule.weights[q] * (1 - t * t));
  }
  return sources;
}

/// Of a whole circle's points those of an arc, packs of eight.
int pointsOn(const RingCircle& circle, int ofCircle) {
  constexpr double pi = 3.14159265358979323846;
  return lanes * static_cast<int>(std::ceil(circle.end() / pi * ofCircle / lanes));
}

}  // namespace

void RingGroups::add(const RingGroup& group, const RingTargets& targets,
                     AlignedLane* to) const {
  const InstructionSet set = largestInstructionSet();
  dispatch(set, Summation<ofForces | withTractions>{lame_, group.circle, targets, states_,
                                                    to});
  dispatch(set, Summation<ofDisplacements | withTractions>{lame_, group.swelling, targets,
                                                           states_, to});
  dispatch(set,
           Summation<ofJumps | withTractions>{lame_, group.ends, targets, states_, to});
}

RingGroups::RingGroups(const ElementRuns& runs, const Lame& lame, const Values& values,
                       std::size_t states, int smallest)
    : RunGroups(runs, smallest), lame_(lame), states_(states) {
  constexpr double ofElement = 1e4;  // ns
  const auto size = static_cast<Index>(groups_.size());
  parallelFor({size, ofElement * runs.mesh().size()}, [&](Index g) {
    if (g > 0)
      sumElements(values, groups_[bem::at(g)]);
  });
}

void RingGroups::addEnds(const Values& values, int e, RingGroup& group) const {
  const Mesh& mesh = runs_.mesh();
  const ElementRange all{runs_[group.first].first, runs_[group.last - 1].last};
  for (const int end : {-1, 1}) {
    const int beside = end < 0 ? mesh[e].previous : mesh[e].next;
    if (all.contain(beside) || mesh.isAxis(beside))
      continue;
    const Vec2 place = mesh[e].curve.point(end);
    group.ends.places.push_back({place.x, place.y, 0, 0, place.x});
    for (std::size_t state = 0; state < states_; ++state)
      group.ends.displacements.push_back(static_cast<double>(end) *
                                         values(e, end, state).displacement);
  }
}

void RingGroups::sumElements(const Values& values, RingGroup& group) const {
  const Mesh& mesh = runs_.mesh();
  const double distance = toPlaces * group.radius;
  RingPointSources all;
  for (int e = runs_[group.first].first; e < runs_[group.last - 1].last; ++e) {
    if (mesh.isAxis(e))
      continue;
    const Element& element = mesh[e];
    const Rule& rule =
        gaussLegendre(farOrder(element.curve.angle(),
                               1 + (toPlaces - 1) * group.radius / element.half) +
                      degreeShare(std::max(element.degree, element.densities)));
    addEnds(values, e, group);
    for (int q = 0; q < rule.size(); ++q) {
      const double t = rule.points[at(q)];
      const double weight = element.half * rule.weights[at(q)];
      const Vec2 place = element.curve.point(t);
      const Vec2 tangent = element.curve.tangent(t);
      all.places.push_back({place.x, place.y, tangent.x, tangent.y, place.x});
      for (std::size_t state = 0; state < states_; ++state) {
        const Value value = values(e, t, state);
        all.forces.push_back(weight * value.force);
        all.displacements.push_back(weight * value.displacement);
      }
    }
  }
  const RingCircle outer{group.centre.real(), distance};
  const RingCircle inner{group.centre.real(), toForces * group.radius};
  const int places = pointsOn(outer, placesAround);
  const int forces = pointsOn(inner, forcesAround);
  const auto placeOn = [&](const RingCircle& circle, int k, int count) {
    return group.centre + std::polar(circle.radius, circle.angle(k, count));
  };
  for (int k = 0; k < forces; ++k) {
    const Complex y = placeOn(inner, k, forces);
    group.circle.places.push_back({y.real(), y.imag(), 0, 0, y.real()});
  }
  // both components of a place or a force; surfaces weighted by their radii
  group.swelling =
      swellingOf({outer.middle + inner.radius, group.centre.imag()}, group.halfOfPiece());
  Matrix system(2 * places, 2 * forces + 1);
  Matrix right(2 * places, static_cast<Index>(states_));
  RingPointSources one;
  const InstructionSet set = largestInstructionSet();
  std::vector<AlignedLane> sums;
  for (int first = 0; first < places; first += lanes) {
    RingTargets targets{};
    Vector scales;
    for (int lane = 0; lane < lanes; ++lane) {
      const Complex x = placeOn(outer, first + lane, places);
      targets.x.lane[lane] = x.real();
      targets.y.lane[lane] = x.imag();
      scales.push_back(1 / std::sqrt(x.real()));
    }
    const auto take = [&](Matrix& to, Index column, double scale, const AlignedLane* by) {
      for (int lane = 0; lane < lanes; ++lane)
        for (int c = 0; c < 2; ++c)
          to(2 * (first + lane) + c, column) =
              scale * scales[at(lane)] * by[c].lane[lane];
    };
    for (int k = 0; k < forces; ++k) {
      one.places = {group.circle.places[at(k)]};
      const double scale = 1 / std::sqrt(one.places[0][0]);
      for (int c = 0; c < 2; ++c) {
        one.forces = {c == 0 ? Complex(1, 0) : Complex(0, 1)};
        sums.assign(4, {});
        dispatch(set, Summation<ofForces>{lame_, one, targets, 1, sums.data()});
        take(system, 2 * k + c, scale, sums.data());
      }
    }
    sums.assign(4, {});
    dispatch(set,
             Summation<ofDisplacements>{lame_, group.swelling, targets, 1, sums.data()});
    take(system, 2 * forces, 1 / std::sqrt(group.radius), sums.data());
    sums.assign(4 * states_, {});
    dispatch(set, Summation<ofForces | ofDisplacements>{lame_, all, targets, states_,
                                                        sums.data()});
    for (std::size_t state = 0; state < states_; ++state)
      take(right, static_cast<Index>(state), 1, &sums[4 * state]);
  }
  // forces in the hole of a ring do nothing that others do not
  constexpr double dependent = 1e-13;
  right = leastSquares(std::move(system), std::move(right), dependent).x;
  for (int k = 0; k < forces; ++k)
    for (std::size_t state = 0; state < states_; ++state)
      group.circle.forces.push_back(1 / std::sqrt(group.circle.places[at(k)][0]) *
                                    Complex(right(2 * k, static_cast<Index>(state)),
                                            right(2 * k + 1, static_cast<Index>(state))));
  for (std::size_t state = 0; state < states_; ++state)
    group.swelled.push_back(right(2 * forces, static_cast<Index>(state)) /
                            std::sqrt(group.radius));
  const std::vector<Complex> unit = std::move(group.swelling.displacements);
  group.swelling.displacements.clear();
  for (const Complex& u : unit)
    for (const double size : group.swelled)
      group.swelling.displacements.push_back(size * u);
}

}  // namespace epafi::bem
