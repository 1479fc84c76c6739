#include "contact/problem/MortarCoupling.hpp"

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
  Writer(const bem::Space& met, bem::Rows mine, Matrix& coupling)
      : met_(met),
        mine_(mine),
        coupling_(coupling),
        rests_(static_cast<std::size_t>(coupling.columns())) {}

  /// Adds - weight χ(t) d · φ(P t).
  void add(const ContactElement& contact, const Vector& chi, const Acting& acting,
           const Opposite::Point& point, double weight) {
    const int degree = met_.mesh()[point.element].degree;
    std::array<double, bem::largestDegree + 1> phi{};
    bem::DisplacementBasis::values(degree, point.t, phi.data());
    const double components[2] = {acting.direction.x, acting.direction.y};
    const double rest = dot(acting.direction, met_.rotationRest(point.element, point.t));
    for (int i = 0; i <= contact.degree; ++i)
      rests_[static_cast<std::size_t>((contact.*acting.number)(i))] -=
          weight * rest * chi[static_cast<std::size_t>(i)];
    for (int k = 0; k <= degree; ++k)
      for (int c = 0; c < 2; ++c) {
        const Index row = met_.displacement(point.element, k, c);
        if (!mine_.contain(row))
          continue;
        for (int i = 0; i <= contact.degree; ++i)
          coupling_(row - mine_.begin, (contact.*acting.number)(i)) -=
              weight * components[c] * chi[static_cast<std::size_t>(i)] *
              phi[static_cast<std::size_t>(k)];
      }
  }

  /// What the rotation of B has beside polynomials, see bem::Rotation.
  void addRotation() const {
    if (met_.rotation() == nullptr)
      return;
    const bem::Vector& functional = met_.rotation()->functional();
    for (Index i = 0; i < coupling_.columns(); ++i)
      for (Index j = 0; j < coupling_.rows(); ++j)
        coupling_(j, i) += functional[static_cast<std::size_t>(j + mine_.begin)] *
                           rests_[static_cast<std::size_t>(i)];
  }

 private:
  const bem::Space& met_;
  bem::Rows mine_;
  Matrix& coupling_;
  Vector rests_;  ///< - ∫ χ_i d_i · (r - r_I) of each coefficient
};

}  // namespace

Matrix mortarCoupling(const bem::Mesh& side, const MultiplierSpace& multiplier,
                      const Opposite& opposite, const bem::Space& met,
                      const bem::DenseAlgebra& algebra, int body) {
  const bem::Rows mine = algebra.myRows(met.displacements());
  Matrix coupling(mine.size(), multiplier.size());
  Writer writer(met, mine, coupling);
  for (const ContactElement& contact : multiplier.elements()) {
    const bem::Element& element = side[contact.element];
    for (const auto& [middle, half] : stretches(opposite, contact)) {
      const auto inside = opposite.at(contact, middle);
      if (inside.element < 0 || inside.body != body)
        continue;
      const bem::Rule& rule = mortarRule(contact, element, met.mesh()[inside.element]);
      for (int q = 0; q < rule.size(); ++q) {
        const double t = middle + half * rule.points[static_cast<std::size_t>(q)];
        const double weight =
            rule.weights[static_cast<std::size_t>(q)] * half * element.half;
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
  writer.addRotation();
  return coupling;
}

const bem::Rule& mortarRule(const ContactElement& contact, const bem::Element& side,
                            const bem::Element& met) {
  const int turning =
      side.curve.isStraight() && met.curve.isStraight() ? 0 : bem::pointsOfTurning;
  return bem::gaussLegendre((contact.degree + met.degree) / 2 + 1 + turning);
}

}  // namespace epafi::contact
