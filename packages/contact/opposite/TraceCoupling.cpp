#include "contact/opposite/TraceCoupling.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/Error.hpp"
#include "contact/opposite/SidePoints.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace epafi::contact {

using bem::Vec2;
using ContactElement = MultiplierSpace::ContactElement;

namespace {

/// Each place once.
std::vector<bem::Entry> summed(std::vector<bem::Entry> entries) {
  std::stable_sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
    return a.column != b.column ? a.column < b.column : a.row < b.row;
  });
  std::vector<bem::Entry> result;
  for (const bem::Entry& entry : entries)
    if (!result.empty() && result.back().row == entry.row &&
        result.back().column == entry.column)
      result.back().value += entry.value;
    else
      result.push_back(entry);
  return result;
}

void checkEnds(const MultiplierSpace& multiplier, const Opposite& opposite) {
  multiplier.forEachElement([&](const ContactElement& element) {
    for (const Coefficients* own : {&element.normal, &element.tangential})
      for (const Coefficients::End& end : own->ends)
        if (!element.condition->name.empty() && (end.clamped || !end.added.empty()) &&
            opposite.meetsDeformable(at(element.body)))
          throw bem::InputError(
              "the multiplier '", multiplier.basis().name,
              "' cannot end at a clamp or at another contact side where it stands "
              "between two bodies; use Gauss-Legendre-Lagrange or Bernstein");
  });
}

}  // namespace

std::vector<TraceCoupling> oppositeCouplings(const std::vector<const bem::Space*>& spaces,
                                             const MultiplierSpace& multiplier,
                                             const Opposite& opposite) {
  std::vector<TraceCoupling> result(spaces.size());
  if (opposite.isStill())
    return result;
  checkEnds(multiplier, opposite);
  forEachSidePoint(
      multiplier, opposite,
      [&](const ContactElement& contact, const Opposite::Point& middle) {
        return middle.element >= 0 ? &ruleOfForces(contact, middle) : nullptr;
      },
      [&](const SidePoint& point) {
        const int opposed = point.opposite.element;
        if (opposed < 0)  // a grazing normal, but for rounding
          return;
        const bem::Space& other = *spaces[at(point.opposite.body)];
        TraceCoupling& coupling = result[at(point.opposite.body)];
        coupling.rests.resize(at(multiplier.size()));
        const int degree = other.mesh()[opposed].degree;
        std::array<double, bem::largestDegree + 1> phi{};
        bem::DisplacementBasis::values(degree, point.opposite.t, phi.data());
        const Vec2 rest = other.rotationRest(opposed, point.opposite.t);
        point.forEachCoefficient([&](Index i, double chi, const Direction& direction) {
          coupling.rests[at(i)] -=
              point.weight * (dot(direction.unit, rest) - direction.oppositeTurn) * chi;
          const double components[2] = {direction.unit.x, direction.unit.y};
          for (int k = 0; k <= degree; ++k)
            for (int c = 0; c < 2; ++c)
              coupling.entries.push_back({other.displacement(opposed, k, c), i,
                                          -point.weight * components[c] * chi * phi[k]});
        });
      });
  for (std::size_t b = 0; b < result.size(); ++b)
    if (!result[b].rests.empty()) {
      result[b].rotation = spaces[b]->rotation();
      result[b].entries = summed(std::move(result[b].entries));
    }
  return result;
}

void dropRounding(const Vector& alongX, const Vector& alongY, const Vector& motion,
                  Vector& moved) {
  constexpr double rounding = 1e-13;
  const double size = bem::largestEntry(motion);
  for (std::size_t i = 0; i < moved.size(); ++i)
    if (std::abs(moved[i]) <= rounding * size * std::hypot(alongX[i], alongY[i]))
      moved[i] = 0;
}

Vector TraceCoupling::apply(const Vector& u) const {
  Vector result(rests.size());
  addApplied(u.data(), result);
  return result;
}

void TraceCoupling::addApplied(const double* u, Vector& r) const {
  for (const bem::Entry& entry : entries)
    r[at(entry.column)] += entry.value * u[entry.row];
  if (rotation == nullptr)
    return;
  const Vector& q = rotation->functional();
  bem::axpy(std::inner_product(q.begin(), q.end(), u, 0.0), rests, r);
}

void TraceCoupling::addTranspose(double s, const double* multiplier,
                                 double* force) const {
  for (const bem::Entry& entry : entries)
    force[entry.row] += s * entry.value * multiplier[entry.column];
  if (rotation == nullptr)
    return;
  const double work = s * std::inner_product(rests.begin(), rests.end(), multiplier, 0.0);
  for (std::size_t j = 0; j < rotation->functional().size(); ++j)
    force[j] += work * rotation->functional()[j];
}

void TraceCoupling::addTo(Matrix& transposed) const {
  for (const bem::Entry& entry : entries)
    transposed(entry.row, entry.column) += entry.value;
  for (std::size_t i = 0; rotation != nullptr && i < rests.size(); ++i)
    if (rests[i] != 0)
      for (Index j = 0; j < transposed.rows(); ++j)
        transposed(j, static_cast<Index>(i)) += rests[i] * rotation->functional()[at(j)];
}

}  // namespace epafi::contact
