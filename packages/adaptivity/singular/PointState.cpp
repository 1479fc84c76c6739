#include "adaptivity/singular/PointState.hpp"

namespace epafi::adaptivity {

PointState pointState(const contact::MultiplierSpace& multiplier,
                      const contact::MultiplierSpace::ContactElement& element, int i,
                      const contact::ContactState& states) {
  if (element.ties())
    return {contact::NormalState::Closed, contact::FrictionState::Stick};
  PointState state{states.normal[element.normalOf(i)], contact::FrictionState::None};
  const bool idle = state.normal == contact::NormalState::Open &&
                    element.condition->friction &&
                    element.condition->friction.law->dependsOnPressure();
  if (element.tangential >= 0 && !idle)
    state.friction = states.tangential[element.tangentialOf(i) - multiplier.normals()];
  return state;
}

}  // namespace epafi::adaptivity
