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
enum Sums { OfForces = 1, OfDisplacements = 2, OfJumps = 4, WithTractions = 8 };

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
        if constexpr ((Wanted & OfForces) != 0)
          addProducts(-1, sources.forces[k * states + state], g.v, g.t, own);
        if constexpr ((Wanted & OfDisplacements) != 0)
          addProducts(-1, sources.displacements[k * states + state], g.k, g.w, own);
        if constexpr ((Wanted & OfJumps) != 0)
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
    if constexpr ((Wanted & WithTractions) != 0)
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
    sources.displacements.emplace_back(half * rule.weights[q] * (1 - t * t));
  }
  return sources;
}

/// Of a whole circle's points those of an arc, packs of eight.
int pointsOn(const RingCircle& circle, int ofCircle) {
  constexpr double pi = 3.14159265358979323846;
  return lanes * static_cast<int>(std::ceil(circle.end() / pi * ofCircle / lanes));
}

Complex placeOn(const RingCircle& circle, double height, int k, int count) {
  return Complex(circle.middle, height) +
         std::polar(circle.radius, circle.angle(k, count));
}

/// What sources do at places of a circle, both components of each, weighted on its surface.
class Places {
 public:
  Places(const RingLame& lame, const RingCircle& circle, double height, int count)
      : lame_(lame), count_(count), packs_(at(count / lanes)) {
    for (int k = 0; k < count; ++k) {
      const Complex x = placeOn(circle, height, k, count);
      packs_[at(k / lanes)].x.lane[k % lanes] = x.real();
      packs_[at(k / lanes)].y.lane[k % lanes] = x.imag();
    }
  }

  Index rows() const { return 2 * count_; }
  /// Sets a column for each state, times a number.
  template <int Wanted>
  void put(const RingPointSources& from, std::size_t states, double scale, Matrix& to,
           Index column) const {
    for (std::size_t p = 0; p < packs_.size(); ++p) {
      std::vector<AlignedLane> sums(4 * states);
      dispatch(Summation<Wanted>{lame_, from, packs_[p], states, sums.data()});
      for (std::size_t state = 0; state < states; ++state)
        for (std::size_t lane = 0; lane < lanes; ++lane)
          for (std::size_t c = 0; c < 2; ++c)
            to(static_cast<Index>(2 * (lanes * p + lane) + c),
               column + static_cast<Index>(state)) = scale /
                                                     std::sqrt(packs_[p].x.lane[lane]) *
                                                     sums[4 * state + c].lane[lane];
    }
  }

 private:
  const RingLame& lame_;
  Index count_;
  std::vector<RingTargets> packs_;
};

}  // namespace

void RingGroups::add(const RingGroup& group, const RingTargets& targets,
                     AlignedLane* to) const {
  dispatch(
      Summation<OfForces | WithTractions>{lame_, group.circle, targets, states_, to});
  dispatch(Summation<OfDisplacements | WithTractions>{lame_, group.swelling, targets,
                                                      states_, to});
  dispatch(Summation<OfJumps | WithTractions>{lame_, group.ends, targets, states_, to});
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

RingPointSources RingGroups::pointsOf(const Values& values,
                                      const RingGroup& group) const {
  const Mesh& mesh = runs_.mesh();
  RingPointSources all;
  for (int e = runs_[group.first].first; e < runs_[group.last - 1].last; ++e) {
    if (mesh.isAxis(e))
      continue;
    const Element& element = mesh[e];
    const Rule& rule =
        gaussLegendre(farOrder(element.curve.angle(),
                               1 + (toPlaces - 1) * group.radius / element.half) +
                      degreeShare(std::max(element.degree, element.densities)));
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
  return all;
}

void RingGroups::sumElements(const Values& values, RingGroup& group) const {
  for (int e = runs_[group.first].first; e < runs_[group.last - 1].last; ++e)
    if (!runs_.mesh().isAxis(e))
      addEnds(values, e, group);
  const double height = group.centre.imag();
  const RingCircle outer{group.centre.real(), toPlaces * group.radius};
  const RingCircle inner{group.centre.real(), toForces * group.radius};
  const int forces = pointsOn(inner, forcesAround);
  for (int k = 0; k < forces; ++k) {
    const Complex y = placeOn(inner, height, k, forces);
    group.circle.places.push_back({y.real(), y.imag(), 0, 0, y.real()});
  }
  group.swelling = swellingOf({inner.middle + inner.radius, height}, group.halfOfPiece());

  const Places places(lame_, outer, height, pointsOn(outer, placesAround));
  Matrix system(places.rows(), 2 * forces + 1);
  Matrix right(places.rows(), static_cast<Index>(states_));
  const auto scaleOf = [&](int k) {
    return 1 / std::sqrt(group.circle.places[at(k)][0]);
  };
  for (int k = 0; k < forces; ++k)
    for (int c = 0; c < 2; ++c) {
      const RingPointSources one{{group.circle.places[at(k)]},
                                 {c == 0 ? Complex(1, 0) : Complex(0, 1)}};
      places.put<OfForces>(one, 1, scaleOf(k), system, 2 * k + c);
    }
  const double ofPiece = 1 / std::sqrt(group.radius);
  places.put<OfDisplacements>(group.swelling, 1, ofPiece, system, 2 * forces);
  places.put<OfForces | OfDisplacements>(pointsOf(values, group), states_, 1, right, 0);
  // forces in the hole of a ring do nothing that others do not
  constexpr double dependent = 1e-13;
  const Matrix x = leastSquares(std::move(system), std::move(right), dependent).x;

  for (int k = 0; k < forces; ++k)
    for (Index state = 0; state < x.columns(); ++state)
      group.circle.forces.push_back(scaleOf(k) *
                                    Complex(x(2 * k, state), x(2 * k + 1, state)));
  for (Index state = 0; state < x.columns(); ++state)
    group.swelled.push_back(ofPiece * x(2 * forces, state));
  const std::vector<Complex> unit = std::move(group.swelling.displacements);
  group.swelling.displacements.clear();
  for (const Complex& u : unit)
    for (const double size : group.swelled)
      group.swelling.displacements.push_back(size * u);
}

}  // namespace epafi::bem
