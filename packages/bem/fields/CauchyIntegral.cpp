#include "bem/fields/CauchyIntegral.hpp"

#include "bem/base/Parallel.hpp"
#include "bem/fields/PointHeaps.hpp"
#include "bem/moments/ElementPotential.hpp"
#include "bem/moments/RelativeTarget.hpp"

#include <algorithm>

namespace epafi::bem {

namespace {

constexpr double twoPi = 6.283185307179586;

/// What an element gives to eight targets, F of density f:  -1/2πi ∫ f τ ds/w.
class Source {
 public:
  Source(const Curve& curve, int terms, const std::array<CauchyIntegral::Series, 2>& f)
      : kernels_(curve, terms) {
    for (int k = 0; k < kernels_.size(); ++k)
      for (std::size_t n = 0; n < 2; ++n)  // τ = iN
        shares_.push_back(-1 / twoPi * kernels_.normal(k) * kernels_.share(f[n], k));
  }

  template <class... Where>
  void evaluate(const Where&... where) {
    kernels_.evaluate(where...);
  }

  void add(std::size_t lane, CauchyIntegral::Pair& to) const {
    for (int k = 0; k < kernels_.size(); ++k) {
      const Complex overW = std::conj(kernels_[k].overConj[static_cast<int>(lane)]);
      to[0] += shares_[static_cast<std::size_t>(2 * k)] * overW;
      to[1] += shares_[static_cast<std::size_t>(2 * k + 1)] * overW;
    }
  }

 private:
  ElementPotential kernels_;
  std::vector<Complex> shares_;
};

/// Adds what a group does, 1/2πi ∫ f τ ds/(y - x).
void addGroup(const SourceGroups::Group& group, Complex x, CauchyIntegral::Pair& to) {
  std::vector<FieldSums> sums(1);
  SourceGroups::addAt(group, x, sums);
  const Complex factor(0, 1 / twoPi);
  to[0] += factor * sums.front().density.overW;
  to[1] += factor * sums.front().slope.overW;
}

}  // namespace

CauchyIntegral::CauchyIntegral(Mesh mesh, std::vector<std::array<Series, 2>> densities)
    : mesh_(std::move(mesh)),
      densities_(std::move(densities)),
      terms_(termsOf(densities_)),
      runs_(mesh_),
      groups_(
          runs_, 2,
          [this](int e, const Rule& rule, std::vector<Complex>& g) {
            setDensities(e, rule, g);
          },
          2, terms_) {}

std::vector<int> CauchyIntegral::termsOf(
    const std::vector<std::array<Series, 2>>& densities) {
  constexpr double rounding = 1e-15;
  double largest[2] = {};
  for (const auto& pair : densities)
    for (std::size_t n = 0; n < 2; ++n)
      for (const Complex c : pair[n])
        largest[n] = std::max(largest[n], std::abs(c));
  std::vector<int> all;
  for (const auto& pair : densities) {
    int terms = 1;
    for (std::size_t n = 0; n < 2; ++n)
      for (int k = 0; k <= largestDegree; ++k)
        if (std::abs(pair[n][bem::at(k)]) > rounding * largest[n])
          terms = std::max(terms, k + 1);
    all.push_back(terms);
  }
  return all;
}

void CauchyIntegral::setDensities(int e, const Rule& rule,
                                  std::vector<Complex>& g) const {
  auto next = g.begin();
  for (const double t : rule.points) {
    const Complex tangent = asComplex(mesh_[e].curve.tangent(t));
    for (const Series& f : densities_[bem::at(e)])
      *next++ = tangent * evaluate(f, terms_[bem::at(e)] - 1, t);
  }
}

std::vector<CauchyIntegral::Pair> CauchyIntegral::at(
    const std::vector<Vec2>& points) const {
  constexpr std::size_t atOnce = 8 * lanes;
  constexpr double ofPoint = 20000;  // ns
  std::vector<Pair> values(points.size());
  const PointHeaps heaps(points, atOnce);
  const double work = ofPoint * static_cast<double>(points.size());
  parallelFor({static_cast<Index>(heaps.size()), work}, [&](Index index) {
    const std::size_t heap = bem::at(index);
    std::vector<std::array<AlignedLane, 2>> places(heaps.packsOf(heap));
    for (std::size_t k = 0; k < places.size() * lanes; ++k) {
      const Vec2 x = points[heaps.number(heap, k)];
      places[k / lanes][0].lane[k % lanes] = x.x;
      places[k / lanes][1].lane[k % lanes] = x.y;
    }
    const auto near = [&](int r) {
      for (int e = runs_[r].first; e < runs_[r].last; ++e) {
        Source source(mesh_[e].curve, terms_[bem::at(e)], densities_[bem::at(e)]);
        for (std::size_t k = 0; k < heaps.pointsOf(heap); ++k) {
          if (k % lanes == 0)
            source.evaluate(places[k / lanes][0], places[k / lanes][1]);
          source.add(k % lanes, values[heaps.number(heap, k)]);
        }
      }
    };
    groups_.visit(
        heaps.centre(heap), heaps.radius(heap),
        [&](const SourceGroups::Group& group) {
          for (std::size_t k = 0; k < heaps.pointsOf(heap); ++k) {
            const std::size_t number = heaps.number(heap, k);
            addGroup(group, asComplex(points[number]), values[number]);
          }
        },
        near);
  });
  return values;
}

// the principal value and half of the element's own density
std::vector<CauchyIntegral::Pair> CauchyIntegral::on(int element,
                                                     const Vector& points) const {
  std::vector<EndPoint> places;
  std::vector<Pair> values;
  for (const double t : points) {
    places.push_back({t, 1 + t, 1 - t});
    const auto& own = densities_[bem::at(element)];
    values.push_back({0.5 * evaluate(own[0], largestDegree, t),
                      0.5 * evaluate(own[1], largestDegree, t)});
  }
  groups_.visit(
      asComplex(mesh_.scaledPoint(element, 0)), mesh_[element].half,
      [&](const SourceGroups::Group& group) {
        for (std::size_t k = 0; k < places.size(); ++k)
          addGroup(group, asComplex(mesh_.scaledPoint(element, places[k].t)), values[k]);
      },
      [&](int r) {
        for (int e = runs_[r].first; e < runs_[r].last; ++e) {
          Source source(mesh_[e].curve, terms_[bem::at(e)], densities_[bem::at(e)]);
          const std::vector<TargetLanes> seen = seenFrom(mesh_, e, element, places);
          for (std::size_t k = 0; k < places.size(); ++k) {
            if (k % lanes == 0)
              source.evaluate(seen[k / lanes]);
            source.add(k % lanes, values[k]);
          }
        }
      });
  return values;
}

}  // namespace epafi::bem
