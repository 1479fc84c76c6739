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

void checkEnds(const MultiplierSpace& multiplier) {
  for (const ContactElement& element : multiplier.elements())
    for (const Coefficients* own : {&element.normal, &element.tangential})
      for (const Coefficients::End& end : own->ends)
        if (!element.condition->name.empty() && (end.clamped || !end.added.empty()))
          throw bem::InputError(
              "the multiplier '", multiplier.basis().name,
              "' cannot end at a clamp or at another contact side where it stands "
              "between two bodies; use Gauss-Legendre-Lagrange or Bernstein");
}

/// Adds to `coupling` that of the multiplier of body a with the displacements of body b.
void addMortar(const std::vector<ContactSide>& bodies, std::size_t a, int b,
               const Numbering& numbering, TraceCoupling& coupling) {
  const auto& [space, multiplier, opposite] = bodies[a];
  const bem::Mesh& side = space.mesh();
  const bem::Space& other = bodies[at(b)].space;
  std::vector<bem::Entry> entries;
  forEachSidePoint(
      side, multiplier, opposite,
      [&](const ContactElement& contact, const Opposite::Point& middle) {
        return middle.element >= 0 && middle.body == b ? &ruleOfForces(contact, middle)
                                                       : nullptr;
      },
      [&](const SidePoint& point) {
        const int opposed = point.opposite.element;
        if (opposed < 0)  // a grazing normal, but for rounding
          return;
        const int degree = other.mesh()[opposed].degree;
        std::array<double, bem::largestDegree + 1> phi{};
        bem::DisplacementBasis::values(degree, point.opposite.t, phi.data());
        const Vec2 rest = other.rotationRest(opposed, point.opposite.t);
        point.forEachCoefficient([&](Index own, double chi, const Direction& direction) {
          const Index i = numbering(a, own);
          coupling.rests[at(i)] -=
              point.weight * (dot(direction.unit, rest) - direction.oppositeTurn) * chi;
          const double components[2] = {direction.unit.x, direction.unit.y};
          for (int k = 0; k <= degree; ++k)
            for (int c = 0; c < 2; ++c)
              entries.push_back({other.displacement(opposed, k, c), i,
                                 -point.weight * components[c] * chi * phi[k]});
        });
      });
  entries = summed(std::move(entries));
  coupling.entries.insert(coupling.entries.end(), entries.begin(), entries.end());
}

}  // namespace

std::vector<TraceCoupling> oppositeCouplings(const std::vector<ContactSide>& bodies,
                                             const Numbering& numbering) {
  std::vector<TraceCoupling> result(bodies.size());
  for (std::size_t a = 0; a < bodies.size(); ++a)
    for (const int b : bodies[a].opposite.bodies()) {
      checkEnds(bodies[a].multiplier);
      TraceCoupling& coupling = result[at(b)];
      coupling.rotation = bodies[at(b)].space.rotation();
      coupling.rests.resize(at(numbering.size()));
      addMortar(bodies, a, b, numbering, coupling);
    }
  return result;
}

Vector onAllMultipliers(const Numbering& numbering, std::size_t b, const Vector& own,
                        const TraceCoupling& opposite, const Vector& u) {
  Vector all(at(numbering.size()));
  for (Index i = 0; i < numbering.sizeOf(b); ++i)
    all[at(numbering(b, i))] = own[at(i)];
  if (!opposite.rests.empty())
    bem::axpy(1, opposite.apply(u), all);
  return all;
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

void TraceCoupling::addTo(Matrix& transposed,
                          const std::function<Index(Index)>& columnOf) const {
  for (const bem::Entry& entry : entries)
    transposed(entry.row, columnOf(entry.column)) += entry.value;
  for (std::size_t i = 0; rotation != nullptr && i < rests.size(); ++i)
    if (rests[i] != 0)
      for (Index j = 0; j < transposed.rows(); ++j)
        transposed(j, columnOf(static_cast<Index>(i))) +=
            rests[i] * rotation->functional()[at(j)];
}

}  // namespace epafi::contact
