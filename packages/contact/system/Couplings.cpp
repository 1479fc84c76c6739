#include "contact/system/Couplings.hpp"

#include "bem/base/Error.hpp"

#include <algorithm>

namespace epafi::contact {

namespace {

bool completesEnds(const MultiplierSpace& multiplier) {
  const auto completed = [](const std::array<EndCompletion, 2>& ends) {
    return std::any_of(ends.begin(), ends.end(), [](const EndCompletion& end) {
      return end.clamped || !end.added.empty();
    });
  };
  return std::any_of(multiplier.elements().begin(), multiplier.elements().end(),
                     [&](const auto& element) {
                       return !element.condition->name.empty() &&
                              (completed(element.normalCompletions) ||
                               completed(element.tangentialCompletions));
                     });
}

void checkEnds(const MultiplierSpace& multiplier) {
  if (completesEnds(multiplier))
    throw bem::InputError(
        "the multiplier '", multiplier.basis().name,
        "' cannot end at a clamp or at another contact side where it stands "
        "between two bodies; use Gauss-Legendre-Lagrange or Bernstein");
}

}  // namespace

Couplings::Couplings(const std::vector<ContactProblem>& bodies, Numbering numbering)
    : numbering_(std::move(numbering)), opposite_(bodies.size()) {
  for (std::size_t a = 0; a < bodies.size(); ++a)
    for (const int b : bodies[a].opposite().bodies()) {
      const bem::Space& space = bodies[at(b)].space();
      checkEnds(bodies[a].multiplier());
      opposite_[at(b)].push_back(
          {a, space.displacements(),
           mortarCoupling(bodies[a].space().mesh(), bodies[a].multiplier(),
                          bodies[a].opposite(), space, b)});
    }
}

Matrix Couplings::transposed(std::size_t b, const StabilisedBody& form) const {
  Matrix own = form.coupling();
  if (opposite_.size() == 1)
    return own;
  Matrix all(own.rows(), numbering_.size());
  for (Index j = 0; j < own.columns(); ++j)
    std::copy_n(own.column(j), own.rows(), all.column(numbering_(b, j)));
  for (const OppositeCoupling& opposite : opposite_[b])
    opposite.coupling.addTo(all,
                            [&](Index i) { return numbering_(opposite.carrier, i); });
  return all;
}

Vector Couplings::gathered(std::size_t b, const Vector& own, const Vector& u) const {
  Vector all(at(numbering_.size()));
  const auto add = [&](std::size_t carrier, const Vector& values) {
    for (Index i = 0; i < numbering_.sizeOf(carrier); ++i)
      all[at(numbering_(carrier, i))] += values[at(i)];
  };
  add(b, own);
  for (const OppositeCoupling& opposite : opposite_[b])
    add(opposite.carrier, opposite.coupling.apply(u));
  return all;
}

Matrix Couplings::multiplierMass(const std::vector<ContactProblem>& bodies) const {
  Matrix all(numbering_.size(), numbering_.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const Matrix own = bodies[b].form().multiplierMass();
    for (Index j = 0; j < own.columns(); ++j)
      for (Index i = 0; i < own.rows(); ++i)
        all(numbering_(b, i), numbering_(b, j)) = own(i, j);
  }
  return all;
}

Vector Couplings::pressOn(std::size_t b, const std::vector<State>& states) const {
  Vector force;
  for (const auto& [carrier, displacements, coupling] : opposite_[b]) {
    force.resize(at(displacements));
    if (!states[carrier].multiplier.empty())
      coupling.addTranspose(states[carrier].multiplier, force);
  }
  return force;
}

}  // namespace epafi::contact
