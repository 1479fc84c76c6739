#include "contact/system/BodyParts.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/body/CoupledBody.hpp"
#include "contact/compressed/CompressedBody.hpp"
#include "contact/system/Definiteness.hpp"

#include <algorithm>

namespace epafi::contact {

using bem::axpy;

std::unique_ptr<const StabilisedBody> makeStabilisedBody(
    const BodyInput& input, const MultiplierSpace& multiplier) {
  if (input.basis.sharesNodes && input.stabilization.form != Stabilization::Form::None)
    throw bem::InputError("the multiplier '", input.basis.name,
                          "' needs the stabilisation's form None");
  return input.stiffness.compressed() != nullptr ? makeCompressedBody(input, multiplier)
                                                 : makeCoupledBody(input, multiplier);
}

BodyParts::BodyParts(const BodyInput& input)
    : space(input.space),
      units(input.units),
      holding(makeHolding(space, input.conditions, units)),
      multiplier(input.space.mesh(), input.basis, input.conditions),
      opposite(input.opposite ? input.opposite
                              : std::make_shared<const DistantObstacle>(
                                    input.space.mesh(), input.units.length)),
      form(makeStabilisedBody(input, multiplier)),
      obstacle(makeObstacle(input.space.mesh(), multiplier, *opposite, input.units)) {
  factor(input);
  numbers.normals = multiplier.normals();
  numbers.tangentials = obstacle.tangentials;
}

double BodyParts::size() const {
  // dimensionless: strains and stresses are of one size
  return holding.loads.size() + obstacle.largestPenetration;
}

void BodyParts::setTerms() {
  if (!terms.force.empty())
    axpy(-1, terms.force, holding.loads.load);
  terms = form->residualTerms(multiplier);
  if (!terms.force.empty())
    axpy(1, terms.force, holding.loads.load);
}

void BodyParts::factor(const BodyInput& input) {
  const double first = input.stabilization.firstGamma0();
  const bool stabilised = input.stabilization.form != Stabilization::Form::None &&
                          !multiplier.elements().empty();
  gamma0 = stabilised ? first : 0;
  setTerms();
  try {
    body = std::make_unique<const ElasticBody>(*form, holding);
    return;
  } catch (const bem::NumericalError&) {
    if (input.stiffness.compressed() != nullptr || form->subtracted().columns() == 0)
      throw;
  }
  const double definiteBelow = limitGamma0(input, *form, holding);
  if (input.stabilization.gamma0)
    throw IndefiniteStiffness(first, definiteBelow);
  gamma0 = std::min(first, definiteBelow) / 4;
  form = form->weakened(gamma0 / first);
  setTerms();
  body = std::make_unique<const ElasticBody>(*form, holding);
}

BodyParts::BodyParts(const BodyParts& same, const Conditions& conditions)
    : space(same.space),
      units(same.units),
      holding(makeHolding(space, conditions, units)),
      multiplier(same.multiplier.under(conditions)),
      opposite(same.opposite),
      form(same.form),
      obstacle(makeObstacle(space.mesh(), multiplier, *opposite, units)),
      gamma0(same.gamma0) {
  setTerms();
  body = std::make_unique<const ElasticBody>(same.body->under(holding));
  numbers.normals = multiplier.normals();
  numbers.tangentials = obstacle.tangentials;
}

Vector BodyParts::push(const State& state, const Vector& met) const {
  if (!state.multiplier.empty() && pushed_.multiplier != state.multiplier)
    pushed_ = {state.multiplier, form->push(state.multiplier)};
  Vector force =
      state.multiplier.empty() ? Vector(holding.loads.load.size(), 0.0) : pushed_.force;
  if (!met.empty())
    axpy(1, met, force);
  return force;
}

}  // namespace epafi::contact
