#include "contact/results/ContactPlace.hpp"

#include <algorithm>

namespace epafi::contact {

ContactPlace::ContactPlace(const Solved& solved, const Element& element, double t)
    : solved_(solved),
      element_(element),
      t_(t),
      place_(element.mesh->physicalPoint(element.element, t)),
      opposite_(solved.problem.opposite().at(element, t)) {}

double ContactPlace::closing(double pressure) const {
  return condition().normal
             ? condition().normal.at(place_, solved_.units).closing(pressure)
             : 0;
}

double ContactPlace::wornBy(Vector Wear::*part) const {
  return condition().wear && solved_.wear != nullptr
             ? MultiplierSpace::throughPoints(solved_.wear->*part, element_, t_)
             : 0;
}

double ContactPlace::opening(double pressure, double normal) const {
  return opposite_.gap + closing(pressure) + worn() +
         dot(motionAt(solved_.motions, opposite_),
             element_.geometry().curve.normal(t_)) -
         normal;
}

double ContactPlace::slip(double tangential, double shear) const {
  const bool isStep = !element_.ties();
  double slip = tangential -
                dot(motionAt(solved_.motions, opposite_) -
                        motionAt(isStep ? solved_.motionsBefore : nullptr, opposite_),
                    element_.geometry().curve.tangent(t_));
  if (condition().friction.compliance) {
    const double earlier =
        isStep && solved_.stateBefore != nullptr
            ? solved_.problem.multiplier()
                  .at(solved_.stateBefore->multiplier, element_, t_)
                  .tangential
            : 0;
    slip -= shearYield() * (shear - earlier);
  }
  if (condition().sliding) {
    const bem::Function earlier =
        isStep && solved_.conditionsBefore != nullptr
            ? solved_.conditionsBefore->contact.at(*element_.boundary).sliding
            : bem::Function();
    slip -= (condition().sliding(place_) - (earlier ? earlier(place_) : 0)) /
            solved_.units.length;
  }
  return slip;
}

double ContactPlace::bound(double pressure) const {
  return condition().friction.at(place_, solved_.units.stress).bound(pressure);
}

double ContactPlace::yield(double pressure, double opening, double stiffness) const {
  const double worn = wornBy(&Wear::rate);
  if (!condition().normal)
    return worn;
  const PointClosing law = condition().normal.at(place_, solved_.units);
  const double pressed = std::max(pressure, 0.0);
  const double touching = std::max(
      pressed,
      law.resolvent(stiffness, pressed + stiffness * (law.closing(pressed) - opening)));
  return touching > 0 ? law.slope(touching) + worn : 0.0;
}

double ContactPlace::shearYield() const {
  const bem::Function& compliance = condition().friction.compliance;
  return compliance ? compliance(place_) * solved_.units.stress / solved_.units.length
                    : 0;
}

double ContactPlace::fineness() const {
  if (opposite_.element < 0 || solved_.motions == nullptr)
    return 1;
  const bem::Element& other =
      solved_.problem.multiplier().mesh(at(opposite_.body))[opposite_.element];
  return std::max(1.0, other.degree * element_.geometry().half /
                           (element_.degree * other.half));
}

}  // namespace epafi::contact
