#include "contact/results/Solved.hpp"

#include <algorithm>

namespace epafi::contact {

using bem::Vec2;

std::function<Vec2(int element, double t)> pressureOn(std::size_t b,
                                                      const std::vector<Solved>& bodies) {
  const int number = static_cast<int>(b);
  std::vector<const Solved*> carriers;
  for (const Solved& solved : bodies) {
    const std::vector<int> met = solved.problem.opposite().bodies();
    if (std::find(met.begin(), met.end(), number) != met.end())
      carriers.push_back(&solved);
  }
  if (carriers.empty())
    return {};
  return [carriers, number](int e, double t) {
    Vec2 sum;
    for (const Solved* side : carriers)
      for (const auto& source : side->problem.opposite().sources(number, e, t)) {
        const auto stress = side->problem.multiplier().at(side->state.multiplier,
                                                          *source.element, source.t);
        const bem::Curve& curve = side->space.mesh()[source.element->element].curve;
        sum = sum + source.stretching * (stress.normal * curve.normal(source.t) +
                                         stress.tangential * curve.tangent(source.t));
      }
    return sum;
  };
}

}  // namespace epafi::contact
