#include "contact/problem/Opposite.hpp"

#include "bem/quadrature/Gauss.hpp"

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
      : met_(met), mine_(mine), coupling_(coupling) {}

  /// Adds - weight χ(t) d · φ(P t).
  void add(const ContactElement& contact, const Vector& chi, const Acting& acting,
           const Opposite::Point& point, double weight) const {
    const int degree = met_.mesh()[point.element].degree;
    std::array<double, bem::largestDegree + 1> phi{};
    bem::DisplacementBasis::values(degree, point.t, phi.data());
    const double components[2] = {acting.direction.x, acting.direction.y};
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

 private:
  const bem::Space& met_;
  bem::Rows mine_;
  Matrix& coupling_;
};

}  // namespace

std::vector<Stretch> stretches(const Opposite& opposite, const ContactElement& element) {
  Vector ends = opposite.breaks(element);
  ends.push_back(1);
  std::vector<Stretch> result;
  double start = -1;
  for (const double end : ends) {
    result.push_back({(start + end) / 2, (end - start) / 2});
    start = end;
  }
  return result;
}

Opposite::Point DistantObstacle::at(const ContactElement& element, double t) const {
  const bem::Function& gap = element.condition->gap;
  return {gap ? gap(mesh_.physicalPoint(element.element, t)) / length_ : 0.0};
}

Vec2 Motions::at(const Opposite::Point& point) const {
  if (point.rigid >= 0)
    return rigid[static_cast<std::size_t>(point.rigid)].at(point.arm);
  if (point.element < 0)
    return {};
  const auto b = static_cast<std::size_t>(point.body);
  return spaces[b]->displacementAt(*displacements[b], point.element, point.t);
}

Vec2 motionAt(const Motions* motions, const Opposite::Point& point) {
  return motions == nullptr ? Vec2{} : motions->at(point);
}

Matrix oppositeCoupling(const bem::Mesh& side, const MultiplierSpace& multiplier,
                        const Opposite& opposite, const bem::Space& met,
                        const bem::DenseAlgebra& algebra, int body) {
  const bem::Rows mine = algebra.myRows(met.displacements());
  Matrix coupling(mine.size(), multiplier.size());
  const Writer writer(met, mine, coupling);
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
  return coupling;
}

}  // namespace epafi::contact
