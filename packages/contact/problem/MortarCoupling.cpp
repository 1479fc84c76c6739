#include "contact/problem/MortarCoupling.hpp"

#include "bem/quadrature/Gauss.hpp"

#include <algorithm>
#include <array>

namespace epafi::contact {

using bem::Vec2;
using ContactElement = MultiplierSpace::ContactElement;

namespace {

/// The coefficients of one element that act in one direction, at one point of the side.
struct Acting {
  Vec2 direction;
  Index (ContactElement::*number)(int) const;
};

class Writer {
 public:
  Writer(const bem::Space& met, std::vector<Coupling::Entry>& entries)
      : met_(met), entries_(entries) {}

  /// Adds - weight χ(t) d · φ(P t).
  void add(const ContactElement& contact, const Vector& chi, const Acting& acting,
           const Opposite::Point& point, double weight) {
    const int degree = met_.mesh()[point.element].degree;
    std::array<double, bem::largestDegree + 1> phi{};
    bem::DisplacementBasis::values(degree, point.t, phi.data());
    const double components[2] = {acting.direction.x, acting.direction.y};
    for (int k = 0; k <= degree; ++k)
      for (int c = 0; c < 2; ++c) {
        const Index row = met_.displacement(point.element, k, c);
        for (int i = 0; i <= contact.degree; ++i)
          entries_.push_back({row, (contact.*acting.number)(i),
                              -weight * components[c] * chi[static_cast<std::size_t>(i)] *
                                  phi[static_cast<std::size_t>(k)]});
      }
  }

 private:
  const bem::Space& met_;
  std::vector<Coupling::Entry>& entries_;
};

/// Each place once.
std::vector<Coupling::Entry> summed(std::vector<Coupling::Entry> entries) {
  std::stable_sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
    return a.column != b.column ? a.column < b.column : a.row < b.row;
  });
  std::vector<Coupling::Entry> result;
  for (const Coupling::Entry& entry : entries)
    if (!result.empty() && result.back().row == entry.row &&
        result.back().column == entry.column)
      result.back().value += entry.value;
    else
      result.push_back(entry);
  return result;
}

}  // namespace

std::vector<Coupling::Entry> mortarCoupling(const bem::Mesh& side,
                                            const MultiplierSpace& multiplier,
                                            const Opposite& opposite,
                                            const bem::Space& met, int body) {
  std::vector<Coupling::Entry> coupling;
  Writer writer(met, coupling);
  for (const ContactElement& contact : multiplier.elements()) {
    const bem::Element& element = side[contact.element];
    for (const auto& [middle, half] : stretches(opposite, contact)) {
      const auto inside = opposite.at(contact, middle);
      if (inside.element < 0 || inside.body != body)
        continue;
      const bem::Rule& rule = bem::gaussLegendre(
          (contact.degree + met.mesh()[inside.element].degree) / 2 + 1);
      for (int q = 0; q < rule.size(); ++q) {
        const double t = middle + half * rule.points[static_cast<std::size_t>(q)];
        const double weight =
            rule.weights[static_cast<std::size_t>(q)] * half * element.half;
        const Vector chi = multiplier.basis().values(contact.degree, t);
        const auto point = opposite.at(contact, t);
        writer.add(contact, chi, {element.curve.normal(t), &ContactElement::normalOf},
                   point, weight);
        if (contact.tangential >= 0)
          writer.add(contact, chi,
                     {element.curve.tangent(t), &ContactElement::tangentialOf}, point,
                     weight);
      }
    }
  }
  return summed(std::move(coupling));
}

}  // namespace epafi::contact
