#include "contact/opposite/RigidBodies.hpp"

#include "contact/opposite/SidePoints.hpp"

#include <algorithm>

namespace epafi::contact {

using bem::Vec2;

RigidTraces rigidTraces(const bem::Mesh& side, const MultiplierSpace& multiplier,
                        const Opposite& opposite, int body) {
  RigidTraces result{Matrix(multiplier.size(), 3)};
  forEachSidePoint(
      side, multiplier, opposite,
      [&](const auto& contact, const Opposite::Point& middle) {
        return middle.rigid == body ? &bem::gaussForGiven(contact.degree) : nullptr;
      },
      [&](const SidePoint& point) {
        const Vec2 arm = point.opposite.arm;
        result.length += point.weight;
        result.lever = std::max(result.lever, norm(arm));
        const std::array<Vec2, 3> motions = {Vec2{1, 0}, Vec2{0, 1}, turnLeft(arm)};
        point.forEachCoefficient([&](Index i, double chi, Vec2 direction) {
          for (Index k = 0; k < 3; ++k)
            result.traces(i, k) += chi * dot(point.weight * motions[k], direction);
        });
      });
  for (Index i = 0; i < multiplier.size() && result.lever > 0; ++i)
    result.traces(i, 2) /= result.lever;
  return result;
}

}  // namespace epafi::contact
