#include "bem/fields/SourceGroups.hpp"

#include "bem/moments/FarOrder.hpp"
#include "bem/quadrature/Gauss.hpp"

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

}  // namespace

SourceGroups::SourceGroups(const ElementRuns& runs, const std::vector<LocalField>& fields)
    : runs_(runs), fields_(fields) {
  if (runs.size() >= 4 * smallestGroup)
    divide(0, runs.size());
}

int SourceGroups::divide(int first, int last) {
  const auto number = static_cast<int>(groups_.size());
  Group group{first, last, {-1, -1}, {}, 0, {}};
  Vec2 low = runs_[first].centre;
  Vec2 high = low;
  for (int r = first; r < last; ++r) {
    low = {std::min(low.x, runs_[r].centre.x), std::min(low.y, runs_[r].centre.y)};
    high = {std::max(high.x, runs_[r].centre.x), std::max(high.y, runs_[r].centre.y)};
  }
  group.centre = asComplex(0.5 * (low + high));
  for (int r = first; r < last; ++r)
    group.radius =
        std::max(group.radius,
                 std::abs(asComplex(runs_[r].centre) - group.centre) + runs_[r].radius);
  if (number > 0) {
    group.moments.resize(termsFor(1 / separation));
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
  const LocalField& values = fields_[f];
  // the circle that targets stay outside of, seen from the element
  const double z = (separation - 1) * group.radius / source.half;
  const Rule& rule =
      gaussLegendre(smoothOrder(std::max(z, 1.1)) + degreeShare(source.degree));
  const Complex middle = asComplex(source.curve.frame().middle) - group.centre;
  for (std::size_t q = 0; q < rule.points.size(); ++q) {
    const double t = rule.points[q];
    const double weight = source.half * rule.weights[q];
    const Complex place = middle + asComplex(source.curve.fromMiddle(t));
    const Complex density = weight * evaluate(values.density, source.densities - 1, t);
    const Complex slope = weight * evaluate(values.slope, source.degree - 1, t);
    const Complex step = place / group.radius;
    Complex power = 1;
    for (Group::Moments& m : group.moments) {
      m.plain[0] += density * power;
      m.plain[1] += slope * power;
      m.conjugate[0] += std::conj(density) * power;
      m.conjugate[1] += std::conj(slope) * power;
      m.shifted[0] += density * std::conj(place) * power;
      m.shifted[1] += slope * std::conj(place) * power;
      power *= step;
    }
  }
}

FieldSums SourceGroups::at(const Group& group, Complex x) {
  const Complex z = x - group.centre;
  const Complex q = group.radius / z;
  const auto terms =
      std::min(static_cast<std::size_t>(termsFor(std::abs(q))), group.moments.size());
  Complex plain[2] = {};
  Complex conjugate[2] = {};
  Complex square[2] = {};
  Complex shifted[2] = {};
  Complex power = 1.0 / z;  // q^(k+1) / R
  for (std::size_t k = 0; k < terms; ++k) {
    const Group::Moments& m = group.moments[k];
    const Complex next = static_cast<double>(k + 1) * power;
    for (int i = 0; i < 2; ++i) {
      plain[i] += power * m.plain[i];
      conjugate[i] += power * m.conjugate[i];
      square[i] += next * m.plain[i];
      shifted[i] += next * m.shifted[i];
    }
    power *= q;
  }
  const auto sums = [&](int i) {
    return SourceSums{plain[i], std::conj(conjugate[i]),
                      std::conj((std::conj(z) * square[i] - shifted[i]) / z)};
  };
  return {sums(0), sums(1)};
}

}  // namespace epafi::bem
