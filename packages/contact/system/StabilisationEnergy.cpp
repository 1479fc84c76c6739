// What the stabilisation stores in a state of a body.
#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/opposite/SidePoints.hpp"
#include "contact/system/ContactBody.hpp"

namespace epafi::contact {

using bem::dot;
using bem::Vec2;
using ContactElement = MultiplierSpace::ContactElement;

// With E = λ + ψ + t - Σ ρ r, on elements that sides see what presses there in λ's place, on pins of
// their elements' means:
//   Σ ∫ γ E · (E - t),   and what t does through f, r and the means of what Fix holds,
// λ + ψ by the rule of forces, all else, h = -Σ ρ r, by that of what is given, as in the equations:
//   γ |λ + ψ|²,   γ (h · (2 (λ + ψ) + h) + t · (λ + ψ + h))
double ContactBody::stabilisationEnergy(const State& state, const Vector& displacement,
                                        const Vector& contactForce,
                                        const Results& results) const {
  if (!coupling().hasCompliance())
    return results.storedEnergy - results.strainEnergy;
  const bem::Mesh& mesh = space_->mesh();
  const BoundaryTraction known = knownTraction();
  const Vector& psi = results.density;
  const Vector rho = fixedReactions(contactForce);
  const auto stressAt = [&](const SidePoint& point) {
    const auto stress = multiplier().at(state.multiplier, point.contact, point.t);
    return stress.normal * point.normal.unit + stress.tangential * point.tangent.unit;
  };
  const auto heldAt = [&](int e, double t) {
    Vec2 held;
    for (const int mode : holding().fixedModes)
      held = held - rho[at(mode)] * holding().modes.at(mode, mesh.scaledPoint(e, t));
    return held;
  };
  const auto ofGiven = [&](int e, double t, Vec2 own) {
    const Vec2 held = heldAt(e, t);
    const double ofHeld = dot(held, 2 * own + held);
    return known ? ofHeld + dot(known(e, t), own + held) : ofHeld;
  };
  const bool isGiven = known || !holding().fixedModes.empty();
  double twice = 0;
  for (std::size_t k = 0; k < elements().size(); ++k) {
    const ContactElement& element = elements()[k];
    const int e = element.element;
    const double gamma = coupling().gamma[k];
    const auto ownAt = [&](const SidePoint& point) {
      return stressAt(point) + space_->densityAt(psi, e, point.t);
    };
    for (const Stretch& stretch : stretches(opposite(), element)) {
      forEachPointOf(
          element, multiplier().basis(),
          ruleOfForces(element, opposite().at(element, stretch.middle)),
          [&](const SidePoint& point) {
            const Vec2 own = ownAt(point);
            twice += gamma * point.stabilising() * dot(own, own);
          },
          stretch);
      if (isGiven)
        forEachPointOf(
            element, multiplier().basis(), bem::gaussForGiven(element.degree),
            [&](const SidePoint& point) {
              twice += gamma * point.stabilising() * ofGiven(e, point.t, ownAt(point));
            },
            stretch);
    }
  }
  // |ψ - λ∘P⁻¹ J|² on what sides see: all that has λ is integrated over them
  for (std::size_t k = elements().size(); k < coupling().elements.size(); ++k) {
    const int e = coupling().elements[k];
    const double gamma = coupling().gamma[k];
    const bem::Rule& rule = bem::gaussForGiven(mesh[e].degree);
    for (int q = 0; q < rule.size(); ++q) {
      const double t = rule.points[at(q)];
      const Vec2 own = space_->densityAt(psi, e, t);
      twice += gamma * mesh.measure(e, 0) * rule.weights[at(q)] *
               (dot(own, own) + ofGiven(e, t, own));
    }
    for (const Opposite::Seen& seen : opposite().seen(static_cast<int>(number_), e)) {
      const Opposite::Point middle = opposite().at(*seen.by, seen.stretch.middle);
      forEachPointOf(seen, multiplier().basis(), ruleOfForces(*seen.by, middle),
                     [&](const SidePoint& point) {
                       const Vec2 stress = stressAt(point);
                       const Vec2 own = space_->densityAt(psi, e, point.opposite.t);
                       twice += gamma * point.stabilisingOpposite(mesh) *
                                dot(point.opposite.stretching * stress - 2 * own, stress);
                     });
      if (isGiven)
        forEachPointOf(seen, multiplier().basis(), bem::gaussForGiven(seen.by->degree),
                       [&](const SidePoint& point) {
                         const double t = point.opposite.t;
                         const Vec2 held = 2 * heldAt(e, t);
                         twice -= gamma * point.stabilisingOpposite(mesh) *
                                  dot(known ? held + known(e, t) : held, stressAt(point));
                       });
    }
  }
  const Loads::InResidual all = inResidual(contactForce);
  const Loads::InResidual& ofKnown = loads_.residual;
  for (const auto& [i, value] : coupling().compliance.pinned) {
    const double given = all.compliance.empty() ? 0 : all.compliance[at(i)];
    const double own =
        ofKnown.compliance.empty() ? given : given - ofKnown.compliance[at(i)];
    twice += (value * psi[at(i)] + given) * (psi[at(i)] + own / value);
  }
  if (known) {
    twice += dot(ofKnown.force, displacement) + dot(ofKnown.terms, state.multiplier);
    for (std::size_t k = 0; k < ofKnown.means.size(); ++k)
      twice += rho[at(holding().fixedModes[k])] / holding().scales[k] * ofKnown.means[k];
  }
  return twice / 2;
}

}  // namespace epafi::contact
