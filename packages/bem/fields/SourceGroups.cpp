#include "bem/fields/SourceGroups.hpp"

#include "bem/base/Parallel.hpp"
#include "bem/moments/Nearness.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "bem/simd/Dispatch.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::bem {

namespace {

constexpr double wanted = 1e-13;
constexpr std::size_t mostTerms = 40;

/// Terms of the series where R/|x - c| = q.
int termsFor(double q) {
  return std::max(4, static_cast<int>(std::ceil(std::log(wanted) / std::log(q))) + 2);
}

/// Σ of the powers times the moments.
struct Series {
  const SourceGroups::Group::Moments* moments;
  std::size_t terms;
  Complex first;
  Complex q;
  ComplexLanes (&sums)[4];  // plain, conjugate, square, shifted

  template <Division>
  EPAFI_INLINE void run() const {
    ComplexPack sum[4];
    Complex power = first;
    for (std::size_t k = 0; k < terms; ++k) {
      const Complex next = static_cast<double>(k + 1) * power;
      const ComplexPack plain = moments[k].plain.load();
      sum[0] = sum[0] + power * plain;
      sum[1] = sum[1] + power * moments[k].conjugate.load();
      sum[2] = sum[2] + next * plain;
      sum[3] = sum[3] + next * moments[k].shifted.load();
      power *= q;
    }
    for (int i = 0; i < 4; ++i)
      sums[i].store(sum[i]);
  }
};

using Moments = SourceGroups::Group::Moments;

/// Adds a point of an element to the moments of eight densities.
struct PointMoments {
  const ComplexLanes& densities;  ///< times the weight
  Complex place;                  ///< y - c
  double radius;
  std::size_t terms;
  Moments* to;

  template <Division>
  EPAFI_INLINE void run() const {
    const ComplexPack g = densities.load();
    const ComplexPack conjugate = conj(g);
    const Complex step = place / radius;
    Complex power = 1;
    for (std::size_t k = 0; k < terms; ++k) {
      Moments& m = to[k];
      m.plain.store(m.plain.load() + power * g);
      m.conjugate.store(m.conjugate.load() + power * conjugate);
      m.shifted.store(m.shifted.load() + (std::conj(place) * power) * g);
      power *= step;
    }
  }
};

/// Adds the moments about another circle, whose middle is at d from the own one:
///
///   ((y - c + d)/R)^k = Σ binomial(k, j) (r/R)^j (d/R)^(k-j) ((y - c)/r)^j
struct MovedMoments {
  const Moments* from;
  double radius;  ///< r
  Complex way;    ///< d
  double newRadius;
  std::size_t terms;
  Moments* to;

  template <Division>
  EPAFI_INLINE void run() const {
    double shrinking[mostTerms] = {1};
    Complex steps[mostTerms] = {1};
    for (std::size_t k = 1; k < terms; ++k) {
      shrinking[k] = shrinking[k - 1] * (radius / newRadius);
      steps[k] = steps[k - 1] * (way / newRadius);
    }
    for (std::size_t k = 0; k < terms; ++k) {
      ComplexPack plain = to[k].plain.load();
      ComplexPack conjugate = to[k].conjugate.load();
      ComplexPack shifted = to[k].shifted.load();
      double binomial = 1;
      for (std::size_t j = 0; j <= k; ++j) {
        const Complex factor = binomial * shrinking[j] * steps[k - j];
        const ComplexPack own = from[j].plain.load();
        plain = plain + factor * own;
        conjugate = conjugate + factor * from[j].conjugate.load();
        shifted = shifted + factor * (from[j].shifted.load() + std::conj(way) * own);
        binomial *= static_cast<double>(k - j) / static_cast<double>(j + 1);
      }
      to[k].plain.store(plain);
      to[k].conjugate.store(conjugate);
      to[k].shifted.store(shifted);
    }
  }
};

}  // namespace

SourceGroups::SourceGroups(const ElementRuns& runs, std::size_t count,
                           const Densities& densities, int smallest,
                           const std::vector<int>& terms)
    : RunGroups(runs, smallest), count_(count) {
  for (std::size_t g = 1; g < groups_.size(); ++g) {
    groups_[g].terms = std::min(bem::at(termsFor(1 / separation)), mostTerms);
    groups_[g].moments.resize(groups_[g].terms * ((count_ + lanes - 1) / lanes));
  }
  constexpr double ofElement = 2000;  // ns
  const auto size = static_cast<Index>(groups_.size());
  parallelFor({size, ofElement * runs.mesh().size()}, [&](Index g) {
    Group& group = groups_[bem::at(g)];
    if (group.children[0] < 0)
      sumElements(densities, terms, group);
  });
  for (std::size_t g = groups_.size(); g-- > 1;) {  // children come behind their parents
    Group& group = groups_[g];
    for (const int number : group.children)
      if (number >= 0) {
        const Group& child = groups_[bem::at(number)];
        for (std::size_t k = 0; k < group.moments.size(); k += group.terms)
          dispatch(MovedMoments{&child.moments[k], child.radius,
                                child.centre - group.centre, group.radius, group.terms,
                                &group.moments[k]});
      }
  }
}

void SourceGroups::sumElements(const Densities& densities, const std::vector<int>& terms,
                               Group& group) const {
  std::vector<Complex> g;
  for (int f = runs_[group.first].first; f < runs_[group.last - 1].last; ++f) {
    const Element& source = runs_.mesh()[f];
    // the circle that targets stay outside of, seen from the element
    const double z = (separation - 1) * group.radius / source.half;
    const Rule& rule = gaussLegendre(
        farOrder(source.curve.angle(), std::max(z, 1.1)) +
        degreeShare(terms.empty() ? std::max(source.degree, source.densities)
                                  : terms[bem::at(f)]));
    g.assign(rule.points.size() * count_, 0);
    densities(f, rule, g);
    const Complex middle = asComplex(source.curve.frame().middle) - group.centre;
    for (std::size_t q = 0; q < rule.points.size(); ++q) {
      const Complex place = middle + asComplex(source.curve.fromMiddle(rule.points[q]));
      for (std::size_t first = 0; first < count_; first += lanes) {
        ComplexLanes eight{};
        for (std::size_t i = first; i < std::min(first + lanes, count_); ++i)
          eight.set(static_cast<int>(i - first),
                    source.half * rule.weights[q] * g[q * count_ + i]);
        dispatch(PointMoments{eight, place, group.radius, group.terms,
                              &group.moments[first / lanes * group.terms]});
      }
    }
  }
}

std::size_t SourceGroups::termsAt(const Group& group, double distance) {
  return std::min(bem::at(termsFor(group.radius / distance)), group.terms);
}

void SourceGroups::addAt(const Group& group, Complex x, std::vector<FieldSums>& sums) {
  const Complex z = x - group.centre;
  const Complex q = group.radius / z;
  const std::size_t terms = termsAt(group, std::abs(z));
  ComplexLanes of[4];
  for (std::size_t i = 0; i < 2 * sums.size(); ++i) {
    const std::size_t lane = i % lanes;
    if (lane == 0)  // q^(k+1) / R
      dispatch(
          Series{group.moments.data() + i / lanes * group.terms, terms, 1.0 / z, q, of});
    const SourceSums own{of[0][lane], std::conj(of[1][lane]),
                         std::conj((std::conj(z) * of[2][lane] - of[3][lane]) / z)};
    (i % 2 == 0 ? sums[i / 2].density : sums[i / 2].slope).add(own);
  }
}

}  // namespace epafi::bem
