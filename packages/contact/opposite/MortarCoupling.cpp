#include "contact/opposite/MortarCoupling.hpp"

#include "bem/algebra/SmallAlgebra.hpp"

#include <algorithm>
#include <array>

namespace epafi::contact {

using bem::Vec2;
using ContactElement = MultiplierSpace::ContactElement;

namespace {

/// The coefficients of one element that act in one direction, at one point of the side.
struct Acting {
  Vec2 direction;
  Index (ContactElement::*number)(int) const = nullptr;
};

class Writer {
 public:
  Writer(const bem::Space& met, MortarCoupling& coupling)
      : met_(met), coupling_(coupling) {}

  /// Adds - weight χ(t) d · φ(P t).
  void add(const ContactElement& contact, const Vector& chi, const Acting& acting,
           const Opposite::Point& point, double weight) const {
    const int degree = met_.mesh()[point.element].degree;
    std::array<double, bem::largestDegree + 1> phi{};
    bem::DisplacementBasis::values(degree, point.t, phi.data());
    const double components[2] = {acting.direction.x, acting.direction.y};
    const double rest = dot(acting.direction, met_.rotationRest(point.element, point.t));
    for (int i = 0; i <= contact.degree; ++i)
      coupling_.rests[(contact.*acting.number)(i)] -= weight * rest * chi[i];
    for (int k = 0; k <= degree; ++k)
      for (int c = 0; c < 2; ++c) {
        const Index row = met_.displacement(point.element, k, c);
        for (int i = 0; i <= contact.degree; ++i)
          coupling_.entries.push_back({row, (contact.*acting.number)(i),
                                       -weight * components[c] * chi[i] * phi[k]});
      }
  }

 private:
  const bem::Space& met_;
  MortarCoupling& coupling_;
};

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

Vector MortarCoupling::pull(const Vector& u) const {
  Vector result(rests.size());
  for (const bem::Entry& entry : entries)
    result[entry.column] += entry.value * u[entry.row];
  if (rotation != nullptr)
    bem::axpy(rotation->amount(u), rests, result);
  return result;
}

void MortarCoupling::push(const Vector& multiplier, Vector& force) const {
  for (const bem::Entry& entry : entries)
    force[entry.row] += entry.value * multiplier[entry.column];
  if (rotation != nullptr)
    rotation->complete(bem::dot(rests, multiplier), force);
}

MortarCoupling mortarCoupling(const bem::Mesh& side, const MultiplierSpace& multiplier,
                              const Opposite& opposite, const bem::Space& met, int body) {
  MortarCoupling coupling{{}, met.rotation(), Vector(at(multiplier.size()))};
  const Writer writer(met, coupling);
  for (const ContactElement& contact : multiplier.elements()) {
    const bem::Element& element = side[contact.element];
    for (const auto& [middle, half] : stretches(opposite, contact)) {
      const auto inside = opposite.at(contact, middle);
      if (inside.element < 0 || inside.body != body)
        continue;
      const bem::Rule& rule = mortarRule(contact, element, met.mesh()[inside.element]);
      for (int q = 0; q < rule.size(); ++q) {
        const double t = middle + half * rule.points[q];
        const double weight = rule.weights[q] * half * element.half;
        const Vector chi = multiplier.basis().values(contact.degree, t);
        const auto point = opposite.at(contact, t);
        if (point.element < 0)  // a grazing normal, but for rounding
          continue;
        writer.add(contact, chi, {element.curve.normal(t), &ContactElement::normalOf},
                   point, weight);
        if (contact.tangential >= 0)
          writer.add(contact, chi,
                     {element.curve.tangent(t), &ContactElement::tangentialOf}, point,
                     weight);
      }
    }
  }
  coupling.entries = summed(std::move(coupling.entries));
  return coupling;
}

const bem::Rule& mortarRule(const ContactElement& contact, const bem::Element& side,
                            const bem::Element& met) {
  const int turning =
      side.curve.isStraight() && met.curve.isStraight() ? 0 : bem::pointsOfTurning;
  return bem::gaussLegendre((contact.degree + met.degree) / 2 + 1 + turning);
}

}  // namespace epafi::contact
