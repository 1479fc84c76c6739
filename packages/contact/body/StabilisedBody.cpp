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

ResidualTerms StabilisedBody::residualTerms(const MultiplierSpace& multiplier) const {
  const BodyLoadSolution& inside = multiplier.conditions().inside;
  if (!inside)
    return {};
  const TractionMoments moments = tractionMoments(space_, multiplier, coupling_, *inside);
  ResidualTerms terms;
  terms.terms.assign(moments.multipliers.size(), 0.0);
  bem::axpy(-1, moments.multipliers, terms.terms);
  if (coupling_.hasCompliance()) {
    terms.compliance = coupling_.complianceOf(space_, moments.weights, *inside);
    std::tie(terms.density, terms.force) = answerTo(terms.compliance);
    for (double& x : terms.density)
      x = -x;
    coupling_.subtractWeighted(coupling_.ofDensities(terms.density), terms.terms);
  } else if (!coupling_.weights.empty()) {
    terms.force = forcesOf(moments.weights);
  }
  return terms;
}

}  // namespace epafi::contact
