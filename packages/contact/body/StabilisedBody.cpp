#include "contact/body/StabilisedBody.hpp"

#include "bem/algebra/SmallAlgebra.hpp"

#include <tuple>

namespace epafi::contact {

Vector StabilisedBody::applyTranspose(const Vector& multiplier) const {
  Vector force(at(space_.displacements()));
  if (!coupling_.weights.empty())
    bem::axpy(-1, forcesOf(coupling_.weighted(multiplier)), force);
  coupling_.trace.addTranspose(multiplier, force);
  coupling_.completion.addTranspose(multiplier, force);
  return force;
}

Vector StabilisedBody::apply(const Vector& u) const {
  Vector result = coupling_.trace.apply(u);
  if (!coupling_.weights.empty())
    coupling_.subtractWeighted(tractionsOf(u), result);
  return result;
}

Vector StabilisedBody::massTimes(const Vector& multiplier) const {
  Vector result = coupling_.massTimes(multiplier);
  if (coupling_.byDensity())
    coupling_.subtractWeighted(responsesTo(coupling_.weighted(multiplier)), result);
  return result;
}

void StabilisedBody::setResidual(const MultiplierSpace& multiplier,
                                 Loads::OfInside& inside) const {
  const BodyLoadSolution& solution = multiplier.conditions().inside;
  if (!solution)
    return;
  setTractionMoments(space_, multiplier, coupling_, *solution, inside);
  if (coupling_.hasCompliance()) {
    inside.compliance = coupling_.complianceOf(space_, inside.weights, *solution);
    std::tie(inside.density, inside.force) = answerTo(inside.compliance);
    for (double& x : inside.density)
      x = -x;
    coupling_.subtractWeighted(coupling_.ofDensities(inside.density), inside.terms);
  } else if (!coupling_.weights.empty()) {
    inside.force = forcesOf(inside.weights);
  }
}

}  // namespace epafi::contact
