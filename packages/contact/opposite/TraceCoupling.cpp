#include "contact/opposite/TraceCoupling.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/opposite/SidePoints.hpp"

#include <algorithm>
#include <array>

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

}  // namespace

Vector TraceCoupling::apply(const Vector& u) const {
  Vector result(rests.size());
  for (const bem::Entry& entry : entries)
    result[at(entry.column)] += entry.value * u[at(entry.row)];
  if (rotation != nullptr)
    bem::axpy(rotation->amount(u), rests, result);
  return result;
}

void TraceCoupling::addTranspose(const Vector& multiplier, Vector& force) const {
  for (const bem::Entry& entry : entries)
    force[at(entry.row)] += entry.value * multiplier[at(entry.column)];
  if (rotation != nullptr)
    rotation->complete(bem::dot(rests, multiplier), force);
}

void TraceCoupling::addTo(Matrix& transposed) const {
  for (const bem::Entry& entry : entries)
    transposed(entry.row, entry.column) += entry.value;
  for (std::size_t i = 0; rotation != nullptr && i < rests.size(); ++i)
    if (rests[i] != 0)
      for (Index j = 0; j < transposed.rows(); ++j)
        transposed(j, static_cast<Index>(i)) += rests[i] * rotation->functional()[at(j)];
}

TraceCoupling mortarCoupling(const bem::Mesh& side, const MultiplierSpace& multiplier,
                             const Opposite& opposite, const bem::Space& other,
                             int body) {
  TraceCoupling coupling{{}, other.rotation(), Vector(at(multiplier.size()))};
  forEachSidePoint(
      side, multiplier, opposite,
      [&](const ContactElement& contact, const Opposite::Point& middle) {
        return middle.element >= 0 && middle.body == body
                   ? &mortarRule(contact, side[contact.element],
                                 other.mesh()[middle.element])
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
        point.forEachCoefficient([&](Index i, double chi, Vec2 direction) {
          coupling.rests[i] -= point.weight * dot(direction, rest) * chi;
          const double components[2] = {direction.x, direction.y};
          for (int k = 0; k <= degree; ++k)
            for (int c = 0; c < 2; ++c)
              coupling.entries.push_back({other.displacement(opposed, k, c), i,
                                          -point.weight * components[c] * chi * phi[k]});
        });
      });
  coupling.entries = summed(std::move(coupling.entries));
  return coupling;
}

const bem::Rule& mortarRule(const ContactElement& contact, const bem::Element& side,
                            const bem::Element& other) {
  const int turning =
      std::max(side.curve.pointsOfTurning(), other.curve.pointsOfTurning());
  return bem::gaussLegendre((contact.degree + other.degree) / 2 + 1 + turning);
}

}  // namespace epafi::contact
