#include "contact/results/Solved.hpp"

#include <algorithm>

namespace epafi::contact {

using bem::Vec2;

ForeignPressure::ForeignPressure(std::size_t b, const std::vector<Solved>& bodies)
    : body_(static_cast<int>(b)) {
  for (const Solved& solved : bodies) {
    const std::vector<int> opposites = solved.problem.opposite().bodies();
    if (std::find(opposites.begin(), opposites.end(), body_) != opposites.end())
      carriers_.push_back(&solved);
  }
}

Vec2 ForeignPressure::at(int element, double t) const {
  Vec2 sum;
  for (const Solved* side : carriers_)
    for (const auto& source : side->problem.opposite().sources(body_, element, t)) {
      const auto stress = side->problem.multiplier().at(side->state.multiplier,
                                                        *source.element, source.t);
      const bem::Curve& curve = side->space.mesh()[source.element->element].curve;
      sum = sum + source.stretching * (stress.normal * curve.normal(source.t) +
                                       stress.tangential * curve.tangent(source.t));
    }
  return sum;
}

Vector ForeignPressure::breaks(int element) const {
  Vector result;
  for (const Solved* side : carriers_) {
    const Vector more = side->problem.opposite().sourceBreaks(body_, element);
    result.insert(result.end(), more.begin(), more.end());
  }
  return result;
}

}  // namespace epafi::contact
