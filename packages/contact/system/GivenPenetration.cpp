#include "contact/system/GivenPenetration.hpp"

#include "bem/quadrature/Gauss.hpp"
#include "contact/opposite/SidePoints.hpp"

namespace epafi::contact {

void addBodyLoads(const Obstacle& obstacle, Vector& r) {
  const MultiplierSpace& multiplier = obstacle.multiplier;
  const auto insideOf = [&](int body) -> const BodyLoadSolution& {
    return multiplier.conditions(at(body)).inside;
  };
  bool anywhere = false;
  for (std::size_t b = 0; b < multiplier.bodies(); ++b)
    anywhere = anywhere || multiplier.conditions(b).inside;
  if (!anywhere)
    return;
  forEachSidePoint(
      multiplier, *obstacle.opposite,
      [](const auto& contact, const Opposite::Point&) {
        return &bem::gaussForGiven(contact.degree);
      },
      [&](const SidePoint& point) {
        const auto& contact = point.contact;
        const Opposite::Point& there = point.opposite;
        bem::Vec2 u;
        if (const BodyLoadSolution& inside = insideOf(contact.body))
          u = inside->displacement(*contact.mesh, contact.element, point.t);
        if (there.element >= 0)
          if (const BodyLoadSolution& inside = insideOf(there.body))
            u = u - inside->displacement(multiplier.mesh(at(there.body)), there.element,
                                         there.t);
        point.forEachCoefficient([&](Index i, double chi, const Direction& direction) {
          r[at(i)] += point.weight * chi * dot(u, direction.unit);
        });
      });
}

}  // namespace epafi::contact
