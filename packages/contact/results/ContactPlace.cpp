#include "contact/results/ContactPlace.hpp"

#include <algorithm>

namespace epafi::contact {

double ContactPlace::closing(double pressure) const {
  const Normal& law = element.condition->normal;
  return law ? law.at(place, solved.units).closing(pressure) : 0;
}

double ContactPlace::worn(Vector Wear::*part) const {
  return element.condition->wear && solved.wear != nullptr
             ? MultiplierSpace::throughPoints(solved.wear->*part, element, t)
             : 0;
}

double ContactPlace::approach(bem::Vec2 u) const {
  return dot(u - motion, opposite.direction.unit) -
         solved.field.turn() * opposite.direction.ownTurn +
         turnAt(solved.motions, opposite) * opposite.direction.oppositeTurn;
}

double ContactPlace::opening(double pressure, bem::Vec2 u) const {
  return opposite.gap + closing(pressure) + worn(&Wear::depth) - approach(u);
}

double ContactPlace::slip(bem::Vec2 u, double shear) const {
  const bool isStep = !element.ties();
  const bem::Vec2 earlier = motionAt(isStep ? solved.motionsBefore : nullptr, opposite);
  double slip = dot(u - (motion - earlier), turnLeft(opposite.direction.unit));
  if (element.condition->friction.compliance) {
    const Vector* before = isStep && solved.stateBefore != nullptr
                               ? &solved.stateBefore->multiplier
                               : nullptr;
    const MultiplierSpace& multiplier = solved.problem.multiplier();
    slip -= shearYield() *
            (shear - (before ? multiplier.at(*before, element, t).tangential : 0));
  }
  if (const bem::Function& sliding = element.condition->sliding) {
    const Conditions* before = isStep ? solved.conditionsBefore : nullptr;
    const bem::Function earlier =
        before ? before->contact.at(*element.boundary).sliding : bem::Function();
    slip -= (sliding(place) - (earlier ? earlier(place) : 0)) / solved.units.length;
  }
  return slip;
}

double ContactPlace::bound(double pressure) const {
  return element.condition->friction.at(place, solved.units.stress).bound(pressure);
}

double ContactPlace::yield(double pressure, double opening, double stiffness) const {
  const double byWear = worn(&Wear::rate);
  if (!element.condition->normal)
    return byWear;
  const PointClosing law = element.condition->normal.at(place, solved.units);
  const double pressed = std::max(pressure, 0.0);
  const double least = stiffness * (law.closing(pressed) - opening);
  const double touching = std::max(pressed, law.resolvent(stiffness, pressed + least));
  return touching > 0 ? law.slope(touching) + byWear : 0.0;
}

double ContactPlace::shearYield() const {
  const bem::Function& compliance = element.condition->friction.compliance;
  return compliance ? compliance(place) * solved.units.stress / solved.units.length : 0;
}

double ContactPlace::fineness() const {
  if (opposite.element < 0 || solved.motions == nullptr)
    return 1;
  const bem::Element& other =
      solved.problem.multiplier().mesh(at(opposite.body))[opposite.element];
  return std::max(1.0,
                  other.degree * element.geometry().half / (element.degree * other.half));
}

}  // namespace epafi::contact
