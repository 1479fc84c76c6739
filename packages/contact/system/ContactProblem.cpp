#include "contact/system/ContactProblem.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/system/BodyParts.hpp"

namespace epafi::contact {

ContactProblem::ContactProblem(std::unique_ptr<BodyParts> parts)
    : parts_(std::move(parts)) {}

ContactProblem::~ContactProblem() = default;
ContactProblem::ContactProblem(ContactProblem&&) noexcept = default;

const Problem& ContactProblem::numbers() const { return parts_->numbers; }
const MultiplierSpace& ContactProblem::multiplier() const { return parts_->multiplier; }
const Opposite& ContactProblem::opposite() const { return *parts_->opposite; }
Index ContactProblem::freeMotions() const { return parts_->body->freeMotions(); }
Vector ContactProblem::moved(const double* motions) const {
  return parts_->body->moved(motions);
}
const Vector& ContactProblem::gap() const { return parts_->obstacle.gap; }
const Vector& ContactProblem::load() const { return parts_->holding.loads.load; }
const Loads::OfInside& ContactProblem::ofInside() const {
  return parts_->holding.loads.inside;
}
double ContactProblem::gamma0() const { return parts_->gamma0; }
double ContactProblem::gamma(std::size_t contactElement) const {
  return parts_->form->gamma(contactElement);
}

Vector ContactProblem::displacement(const State& state, const Vector& met) const {
  const Vector still(parts_->body->freeMotions(), 0.0);
  return parts_->body->displacement(
      parts_->push(state, met), state.rigid.empty() ? still.data() : state.rigid.data());
}

bool ContactProblem::byDensity() const { return parts_->form->byDensity(); }

std::vector<bem::Vec2> ContactProblem::meanSlacks(const State& state,
                                                  const Vector& density) const {
  return parts_->form->meanSlacks(state.multiplier, density, parts_->terms.compliance);
}

double ContactProblem::strainEnergy(const State& state,
                                    const Vector& displacement) const {
  return parts_->form->strainEnergy(displacement, state.multiplier, parts_->terms);
}

double ContactProblem::storedEnergy(const State& state,
                                    const Vector& displacement) const {
  const Vector none(displacement.size(), 0.0);
  const Vector force = parts_->form->residual(none, displacement);  // -A u
  double twice = 0;
  for (std::size_t i = 0; i < force.size(); ++i)
    twice -= force[i] * displacement[i];
  if (!state.multiplier.empty())
    twice += parts_->form->multiplierWork(state.multiplier);
  return twice / 2;
}

Vector ContactProblem::density(const State& state, const Vector& displacement) const {
  Vector psi = parts_->form->density(displacement, state.multiplier);
  if (!parts_->terms.density.empty())
    bem::axpy(1, parts_->terms.density, psi);
  return psi;
}

Vector ContactProblem::clampForces(const State& state, const Vector& displacement,
                                   const Vector& met) const {
  return parts_->body->clampForces(parts_->push(state, met), displacement);
}

Vector ContactProblem::clampWork(const State& state, const Vector& displacement,
                                 const Vector& met) const {
  return parts_->body->clampWork(parts_->push(state, met), displacement);
}

Vector ContactProblem::fixedReactions(const State& state, const Vector& met) const {
  return parts_->body->fixedReactions(parts_->push(state, met));
}

Vector ContactProblem::fixedMeans(const Vector& displacement) const {
  const Holding& holding = parts_->holding;
  Vector means(3, 0.0);
  for (std::size_t i = 0; i < displacement.size(); ++i)
    for (Index k = 0; holding.loads.clamped[i] == 0 && k < 3; ++k)
      means[at(k)] +=
          holding.modes.functionals(static_cast<Index>(i), k) * displacement[i];
  return means;
}

}  // namespace epafi::contact
