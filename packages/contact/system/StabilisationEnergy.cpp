// What the stabilisation stores in a state of a body.
#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/quadrature/Piecewise.hpp"
#include "contact/opposite/SidePoints.hpp"
#include "contact/system/ContactBody.hpp"

namespace epafi::contact {

using bem::dot;
using bem::Vec2;

// With E = λ + ψ + t_p - Σ ρ r, on elements that sides see what presses there in λ's place, on pins of
// their elements' means:
//   Σ ∫ γ E · (E - t_p),   and what t_p does through f, r and the means of what Fix holds
double ContactBody::stabilisationEnergy(const State& state, const Vector& displacement,
                                        const Vector& contactForce) const {
  if (!coupling().hasCompliance())
    return storedEnergy(state, displacement, contactForce) -
           strainEnergy(state, displacement, contactForce);
  const bem::Mesh& mesh = space_->mesh();
  const BodyLoadSolution& inside = conditions().inside;
  const Vector psi = density(state, displacement, contactForce);
  const Vector rho = fixedReactions(contactForce);
  double twice = 0;
  const auto add = [&](int e, double t, double weight, Vec2 pressed) {
    Vec2 own = pressed + space_->densityAt(psi, e, t);
    for (const int mode : holding().fixedModes)
      own = own - rho[at(mode)] * holding().modes.at(mode, mesh.scaledPoint(e, t));
    const Vec2 whole = inside ? own + inside->traction(mesh, e, t) : own;
    twice += weight * dot(whole, own);
  };
  for (std::size_t k = 0; k < elements().size(); ++k)
    for (const Stretch& stretch : stretches(opposite(), elements()[k]))
      forEachPointOf(
          elements()[k], multiplier().basis(), bem::gaussForGiven(elements()[k].degree),
          [&](const SidePoint& point) {
            const auto stress = multiplier().at(state.multiplier, elements()[k], point.t);
            add(elements()[k].element, point.t, coupling().gamma[k] * point.weight,
                stress.normal * point.normal.unit +
                    stress.tangential * point.tangent.unit);
          },
          stretch);
  for (std::size_t k = elements().size(); k < coupling().elements.size(); ++k) {
    const int e = coupling().elements[k];
    const auto faced = static_cast<int>(number_);
    const bem::Rule rule = bem::piecewiseRule(opposite().sourceBreaks(faced, e),
                                              bem::gaussForGiven(mesh[e].degree).size());
    for (int q = 0; q < rule.size(); ++q) {
      const double t = rule.points[at(q)];
      add(e, t, coupling().gamma[k] * mesh[e].half * rule.weights[at(q)],
          -foreignTraction(state.multiplier, e, t));
    }
  }
  const Loads::InResidual all = inResidual(contactForce);
  const Loads::InResidual& ofInside = loads_.residual;
  for (const auto& [i, value] : coupling().compliance.pinned) {
    const double given = all.compliance.empty() ? 0 : all.compliance[at(i)];
    const double own =
        ofInside.compliance.empty() ? given : given - ofInside.compliance[at(i)];
    twice += (value * psi[at(i)] + given) * (psi[at(i)] + own / value);
  }
  if (inside) {
    twice += dot(ofInside.force, displacement) + dot(ofInside.terms, state.multiplier);
    for (std::size_t k = 0; k < ofInside.means.size(); ++k)
      twice += rho[at(holding().fixedModes[k])] / holding().scales[k] * ofInside.means[k];
  }
  return twice / 2;
}

}  // namespace epafi::contact
