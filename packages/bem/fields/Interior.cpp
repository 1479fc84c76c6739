#include "bem/fields/Interior.hpp"

#include "bem/kernel/ElementSums.hpp"
#include "bem/moments/ArcWeights.hpp"
#include "bem/space/LocalField.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::bem {

namespace {

/// V of f P_j in closed form.
Complex singleLayerOf(const Lame& lame, const Element& element,
                      const RelativeTarget& target, const LegendreMoments& m, int j,
                      Complex f) {
  const Complex tangent = asComplex(element.segment().tangent);
  const double whole = j == 0 ? 2 : 0;
  const Complex phase = tangent * tangent * (whole - Complex(0, 2 * target.b()) * m.c[j]);
  return element.half * singleLayer(lame, (m.l[j] + whole * std::log(element.half)) * f,
                                    whole * f, std::conj(f) * phase);
}

/// Displacement and sums of what is on one element.
struct ElementFields {
  Complex displacement;
  FieldSums sums;
};

ElementFields fieldsOfSegment(const Lame& lame, const Element& element,
                              const RelativeTarget& target, const LocalField& field,
                              int terms) {
  ElementFields fields;
  ElementSums in;
  in.evaluate(element.curve, target, terms + 1, Need::All);
  const Complex normal = asComplex(element.segment().normal);
  for (int j = 0; j <= terms; ++j) {
    const Complex v = field.value[j];
    fields.displacement -=
        doubleLayer(lame, normal * v * in[j], std::real(std::conj(normal) * v) * in[j]);
    fields.displacement +=
        singleLayerOf(lame, element, target, in.moments(), j, field.density[j]);
    fields.sums.add({field.density[j] * in[j], field.slope[j] * in[j]});
  }
  return fields;
}

/// At the points of an arc.
ElementFields fieldsOfArc(const Lame& lame, const Element& element,
                          const RelativeTarget& target, const LocalField& field,
                          int terms) {
  const ArcRule rule(element.curve, terms);
  ArcWeights weights;
  weights.evaluate(rule, target, ArcNeed::All);
  ElementFields fields;
  for (int q = 0; q < rule.size(); ++q) {
    const double t = rule.point(q);
    const double half = element.half;
    const Complex normal = rule.normal(q);
    const SourceSums unit = {half * weights.overW[q], half * std::conj(weights.overW[q]),
                             half * weights.cubic[q]};
    const Complex v = evaluate(field.value, element.degree, t);
    const Complex f = evaluate(field.density, element.densities - 1, t);
    fields.displacement -=
        doubleLayer(lame, normal * v * unit, std::real(std::conj(normal) * v) * unit);
    fields.displacement +=
        half * singleLayer(lame, weights.log[q] * f, rule.weight(q) * f,
                           std::conj(f) * weights.phase[q]);
    fields.sums.add({f * unit, evaluate(field.slope, element.degree - 1, t) * unit});
  }
  return fields;
}

}  // namespace

InteriorValue evaluateInterior(const Space& space, const Lame& lame, const Vector& u,
                               const Vector& psi, Vec2 x) {
  Complex displacement = 0;
  FieldSums sums;
  const Vector inner = space.withoutRotation(u);
  for (int e = 0; e < space.mesh().size(); ++e) {
    const Element& element = space.mesh()[e];
    const RelativeTarget target = element.curve.seen(x);
    const int terms = std::max(element.degree, element.densities);
    const auto ofElement = element.curve.isStraight() ? fieldsOfSegment : fieldsOfArc;
    const ElementFields fields =
        ofElement(lame, element, target, localField(space, inner, psi, e), terms);
    displacement += fields.displacement;
    sums.add(fields.sums);
  }
  if (space.rotation() != nullptr)
    displacement += space.rotation()->amount(u) * asComplex(space.rotation()->at(x));
  const Complex onX = traction(lame, Complex(1, 0), sums);
  const Complex onY = traction(lame, Complex(0, 1), sums);
  return {asVector(displacement), onX.real(), onY.imag(),
          0.5 * (onX.imag() + onY.real())};
}

}  // namespace epafi::bem
