#include "contact/system/OppositeCouplings.hpp"

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

std::vector<TraceCoupling> oppositeCouplings(const std::vector<ContactProblem>& bodies,
                                             const Numbering& numbering) {
  std::vector<TraceCoupling> result(bodies.size());
  for (std::size_t a = 0; a < bodies.size(); ++a)
    for (const int b : bodies[a].opposite().bodies()) {
      const bem::Space& space = bodies[at(b)].space();
      checkEnds(bodies[a].multiplier());
      TraceCoupling& all = result[at(b)];
      all.rotation = space.rotation();
      all.rests.resize(at(numbering.size()));
      all.add(mortarCoupling(bodies[a].space().mesh(), bodies[a].multiplier(),
                             bodies[a].opposite(), space, b),
              [&](Index i) { return numbering(a, i); });
    }
  return result;
}

}  // namespace epafi::contact
