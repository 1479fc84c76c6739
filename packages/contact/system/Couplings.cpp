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

Couplings::Couplings(const AllBodyParts& bodies, Numbering numbering)
    : numbering_(std::move(numbering)), met_(bodies.size()) {
  for (std::size_t a = 0; a < size(); ++a)
    for (const int b : bodies[a]->opposite->bodies()) {
      checkEnds(bodies[a]->multiplier);
      met_[b].push_back({a, mortarCoupling(bodies[a]->space.mesh(), bodies[a]->multiplier,
                                           *bodies[a]->opposite, bodies[b]->space, b)});
    }
}

Matrix Couplings::transposed(std::size_t b, const BodyParts& body) const {
  Matrix own = body.form->coupling();
  if (size() == 1)
    return own;
  Matrix all(own.rows(), numbering_.size());
  for (Index j = 0; j < own.columns(); ++j)
    std::copy_n(own.column(j), own.rows(), all.column(numbering_(b, j)));
  for (const auto& [carrier, coupling] : met_[b]) {
    for (const bem::Entry& entry : coupling.entries)
      all(entry.row, numbering_(carrier, entry.column)) += entry.value;
    if (coupling.rotation == nullptr)
      continue;
    const Vector& q = coupling.rotation->functional();
    for (Index i = 0; i < numbering_.sizeOf(carrier); ++i)
      for (Index j = 0; j < all.rows(); ++j)
        all(j, numbering_(carrier, i)) += q[j] * coupling.rests[i];
  }
  return all;
}

Vector Couplings::pull(std::size_t b, const BodyParts& body, const Vector& u) const {
  return gathered(b, body.form->pull(u), u);
}

Vector Couplings::contactTerms(std::size_t b, const BodyParts& body, const Vector& u,
                               const Vector& multiplier) const {
  return gathered(b, body.form->contactTerms(u, multiplier), u);
}

Vector Couplings::gathered(std::size_t b, const Vector& own, const Vector& u) const {
  Vector all(numbering_.size());
  const auto add = [&](std::size_t carrier, const Vector& values) {
    for (Index i = 0; i < numbering_.sizeOf(carrier); ++i)
      all[numbering_(carrier, i)] += values[i];
  };
  add(b, own);
  for (const auto& [carrier, coupling] : met_[b])
    add(carrier, coupling.pull(u));
  return all;
}

Matrix Couplings::multiplierMass(const AllBodyParts& bodies) const {
  if (size() == 1)
    return bodies.front()->form->multiplierMass();
  Matrix all(numbering_.size(), numbering_.size());
  for (std::size_t b = 0; b < size(); ++b) {
    const Matrix own = bodies[b]->form->multiplierMass();
    for (Index j = 0; j < own.columns(); ++j)
      for (Index i = 0; i < own.rows(); ++i)
        all(numbering_(b, i), numbering_(b, j)) = own(i, j);
  }
  return all;
}

Vector Couplings::pressOn(std::size_t b, const BodyParts& body,
                          const std::vector<State>& states) const {
  Vector force;
  for (const auto& [carrier, coupling] : met_[b]) {
    force.resize(body.holding.loads.load.size());
    if (!states[carrier].multiplier.empty())
      coupling.push(states[carrier].multiplier, force);
  }
  return force;
}

}  // namespace epafi::contact
