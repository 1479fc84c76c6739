#include "bem/fields/CauchyIntegral.hpp"

#include "bem/base/Parallel.hpp"
#include "bem/moments/ElementPotential.hpp"
#include "bem/moments/RelativeTarget.hpp"

#include <algorithm>

namespace epafi::bem {

namespace {

/// What an element gives to eight targets, F of density f:  -1/2πi ∫ f τ ds/w.
class Source {
 public:
  Source(const Curve& curve, int terms, const std::array<CauchyIntegral::Series, 2>& f)
      : kernels_(curve, terms) {
    constexpr double twoPi = 6.283185307179586;
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

}  // namespace

CauchyIntegral::CauchyIntegral(Mesh mesh, std::vector<std::array<Series, 2>> densities)
    : mesh_(std::move(mesh)), densities_(std::move(densities)) {
  constexpr double rounding = 1e-15;
  double largest[2] = {};
  for (const auto& pair : densities_)
    for (std::size_t n = 0; n < 2; ++n)
      for (const Complex c : pair[n])
        largest[n] = std::max(largest[n], std::abs(c));
  for (const auto& pair : densities_) {
    int terms = 1;
    for (std::size_t n = 0; n < 2; ++n)
      for (int k = 0; k <= largestDegree; ++k)
        if (std::abs(pair[n][bem::at(k)]) > rounding * largest[n])
          terms = std::max(terms, k + 1);
    terms_.push_back(terms);
  }
}

std::vector<CauchyIntegral::Pair> CauchyIntegral::at(
    const std::vector<Vec2>& points) const {
  constexpr std::size_t atOnce = 8 * lanes;
  constexpr double ofElement = 20;  // ns
  std::vector<Pair> values(points.size());
  const std::size_t rounds = (points.size() + atOnce - 1) / atOnce;
  const double work = ofElement * static_cast<double>(points.size()) * mesh_.size();
  parallelFor({static_cast<Index>(rounds), work}, [&](Index round) {
    const std::size_t first = bem::at(round) * atOnce;
    const std::size_t last = std::min(first + atOnce, points.size());
    for (int e = 0; e < mesh_.size(); ++e) {
      Source source(mesh_[e].curve, terms_[bem::at(e)], densities_[bem::at(e)]);
      for (std::size_t k = first; k < last; k += lanes) {
        AlignedLane x{};
        AlignedLane y{};
        for (std::size_t lane = 0; lane < lanes; ++lane) {
          const Vec2 point = points[std::min(k + lane, last - 1)];
          x.lane[lane] = point.x;
          y.lane[lane] = point.y;
        }
        source.evaluate(x, y);
        for (std::size_t lane = 0; lane < lanes && k + lane < last; ++lane)
          source.add(lane, values[k + lane]);
      }
    }
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
  for (int e = 0; e < mesh_.size(); ++e) {
    Source source(mesh_[e].curve, terms_[bem::at(e)], densities_[bem::at(e)]);
    const std::vector<TargetLanes> seen = seenFrom(mesh_, e, element, places);
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (k % lanes == 0)
        source.evaluate(seen[k / lanes]);
      source.add(k % lanes, values[k]);
    }
  }
  return values;
}

}  // namespace epafi::bem
