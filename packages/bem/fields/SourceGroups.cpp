#include "bem/fields/SourceGroups.hpp"

#include "bem/base/Box.hpp"
#include "bem/moments/Nearness.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "bem/simd/Dispatch.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::bem {

namespace {

// So many runs cost what a group's moments do.
constexpr int smallestGroup = 16;

constexpr double wanted = 1e-13;

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

}  // namespace

SourceGroups::SourceGroups(const ElementRuns& runs, const std::vector<LocalField>& fields,
                           std::size_t states)
    : runs_(runs), fields_(fields), states_(states) {
  if (runs.size() >= 4 * smallestGroup)
    divide(0, runs.size());
}

int SourceGroups::divide(int first, int last) {
  const auto number = static_cast<int>(groups_.size());
  Group group{first, last, {-1, -1}, {}, 0, {}, 0};
  Box box;
  for (int r = first; r < last; ++r)
    box.add(runs_[r].centre);
  group.centre = asComplex(box.middle());
  for (int r = first; r < last; ++r)
    group.radius =
        std::max(group.radius,
                 std::abs(asComplex(runs_[r].centre) - group.centre) + runs_[r].radius);
  if (number > 0) {
    group.terms = termsFor(1 / separation);
    group.moments.resize(group.terms * ((states_ + statesInLanes - 1) / statesInLanes));
    for (int r = first; r < last; ++r)
      for (int f = runs_[r].first; f < runs_[r].last; ++f)
        addElement(f, group);
  }
  groups_.push_back(std::move(group));
  if (last - first < 2 * smallestGroup)
    return number;
  const int left = divide(first, (first + last) / 2);
  const int right = divide((first + last) / 2, last);
  groups_[number].children[0] = left;
  groups_[number].children[1] = right;
  return number;
}

void SourceGroups::addElement(int f, Group& group) const {
  const Element& source = runs_.mesh()[f];
  // the circle that targets stay outside of, seen from the element
  const double z = (separation - 1) * group.radius / source.half;
  const Rule& rule = gaussLegendre(farOrder(source.curve.angle(), std::max(z, 1.1)) +
                                   degreeShare(source.degree));
  const Complex middle = asComplex(source.curve.frame().middle) - group.centre;
  std::vector<Complex> carried(2 * states_);
  for (std::size_t q = 0; q < rule.points.size(); ++q) {
    const double t = rule.points[q];
    const double weight = source.half * rule.weights[q];
    const Complex place = middle + asComplex(source.curve.fromMiddle(t));
    const Complex step = place / group.radius;
    for (std::size_t i = 0; i < 2 * states_; ++i) {
      const LocalField& values = fields_[f * states_ + i / 2];
      carried[i] =
          weight * (i % 2 == 0 ? evaluate(values.density, source.densities - 1, t)
                               : evaluate(values.slope, source.degree - 1, t));
    }
    Complex power = 1;
    for (std::size_t k = 0; k < group.terms; ++k) {
      const Complex shifted = std::conj(place) * power;
      for (std::size_t i = 0; i < 2 * states_; ++i) {
        Group::Moments& m = group.moments[i / lanes * group.terms + k];
        const auto add = [lane = static_cast<int>(i % lanes)](ComplexLanes& to,
                                                              Complex value) {
          to.set(lane, to[lane] + value);
        };
        add(m.plain, carried[i] * power);
        add(m.conjugate, std::conj(carried[i]) * power);
        add(m.shifted, carried[i] * shifted);
      }
      power *= step;
    }
  }
}

void SourceGroups::addAt(const Group& group, Complex x, std::vector<FieldSums>& sums,
                         InstructionSet set) {
  const Complex z = x - group.centre;
  const Complex q = group.radius / z;
  const auto terms =
      std::min(static_cast<std::size_t>(termsFor(std::abs(q))), group.terms);
  ComplexLanes of[4];
  for (std::size_t i = 0; i < 2 * sums.size(); ++i) {
    const std::size_t lane = i % lanes;
    if (lane == 0)  // q^(k+1) / R
      dispatch(set, Series{group.moments.data() + i / lanes * group.terms, terms, 1.0 / z,
                           q, of});
    const SourceSums own{of[0][lane], std::conj(of[1][lane]),
                         std::conj((std::conj(z) * of[2][lane] - of[3][lane]) / z)};
    (i % 2 == 0 ? sums[i / 2].density : sums[i / 2].slope).add(own);
  }
}

}  // namespace epafi::bem
