// What the stabilisation stores in a state of a body.
#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/opposite/SidePoints.hpp"
#include "contact/system/ContactBody.hpp"

namespace epafi::contact {

using bem::dot;
using bem::Vec2;

// With E = λ + ψ + t - Σ ρ r, on pins of their elements' means:
//   Σ ∫ γ E · (E - t),   and what t does through f, r and the means of what Fix holds,
// λ + ψ by the rule of forces, all else, h = -Σ ρ r, by that of what is given, as in the equations:
//   γ |λ + ψ|²,   γ (h · (2 (λ + ψ) + h) + t · (λ + ψ + h))
double ContactBody::stabilisationEnergy(const State& state, const Vector& displacement,
                                        const Vector& contactForce) const {
  if (!coupling().hasCompliance())
    return storedEnergy(state, displacement, contactForce) -
           strainEnergy(state, displacement, contactForce);
  const bem::Mesh& mesh = space_->mesh();
  const BoundaryTraction known = knownTraction();
  const Vector psi = density(state, displacement, contactForce);
  const Vector rho = fixedReactions(contactForce);
  double twice = 0;
  for (std::size_t k = 0; k < elements().size(); ++k) {
    const auto& element = elements()[k];
    const int e = element.element;
    const auto ownAt = [&](const SidePoint& point) {
      const auto stress = multiplier().at(state.multiplier, element, point.t);
      return stress.normal * point.normal.unit + stress.tangential * point.tangent.unit +
             space_->densityAt(psi, e, point.t);
    };
    const auto heldAt = [&](const SidePoint& point) {
      Vec2 held;
      for (const int mode : holding().fixedModes)
        held =
            held - rho[at(mode)] * holding().modes.at(mode, mesh.scaledPoint(e, point.t));
      return held;
    };
    const double gamma = coupling().gamma[k];
    for (const Stretch& stretch : stretches(opposite(), element)) {
      forEachPointOf(
          element, multiplier().basis(),
          ruleOfForces(element, opposite().at(element, stretch.middle)),
          [&](const SidePoint& point) {
            const Vec2 own = ownAt(point);
            twice += gamma * point.stabilising() * dot(own, own);
          },
          stretch);
      if (known || holding().fixed() > 0)
        forEachPointOf(
            element, multiplier().basis(), bem::gaussForGiven(element.degree),
            [&](const SidePoint& point) {
              const Vec2 own = ownAt(point);
              const Vec2 held = heldAt(point);
              const Vec2 given = known ? known(e, point.t) : Vec2{};
              twice += gamma * point.stabilising() *
                       (dot(held, 2 * own + held) + dot(given, own + held));
            },
            stretch);
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
