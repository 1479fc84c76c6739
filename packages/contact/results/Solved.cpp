#include "contact/results/Solved.hpp"

#include "contact/multiplier/ContinuousMultiplier.hpp"
#include "contact/results/ContactPlace.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::contact {

using bem::Vec2;

namespace {

constexpr double stateTolerance = 1e-9;  // of the load; Newton stops far below

Vector boundsAsCoefficients(const ContactBody& body, const Vector& multiplier) {
  const Index normals = body.multiplier().normals();
  const Vector zero(multiplier.empty() ? at(normals) : 0);
  Vector result(at(body.multiplier().size()));
  for (const Index i : body.columns())
    if (i >= normals)
      result[at(i)] = body.obstacle().tangentials[at(i - normals)].bound(
          multiplier.empty() ? zero : multiplier);
  return result;
}

}  // namespace

ContactFields::ContactFields(const Solved& solved)
    : solved_(solved),
      units_(solved.units),
      multiplier_(solved.state.multiplier),
      bounds_(boundsAsCoefficients(solved.problem, solved.state.multiplier)),
      tolerance_(stateTolerance * solved.problem.stress()) {}

double ContactFields::closing(const Element& element,
                              const MultiplierSpace::Value& stress) const {
  return element.ties() ? tolerance_ : stress.normal - tolerance_;
}

double ContactFields::closing(const Element& element, double t) const {
  return closing(element, multiplierSpace().at(multiplier_, element, t));
}

double ContactFields::slipping(const Element& element, double shear, double bound) const {
  if (!element.shears() || element.ties() || bound <= tolerance_)
    return -tolerance_;
  return std::abs(shear) - bound + tolerance_;
}

double ContactFields::slipping(const Element& element, double t) const {
  const double bound = multiplierSpace().at(bounds_, element, t).tangential;
  if (bound == 0 && element.shears() && !element.ties())
    return closing(element, t);  // a bound of zero is reached wherever sides touch
  return slipping(element, multiplierSpace().at(multiplier_, element, t).tangential,
                  bound);
}

MultiplierSpace::Value ContactFields::inUnits(const Vector& multiplier,
                                              const Element& element, double t) const {
  const auto stress = multiplierSpace().at(multiplier, element, t);
  return {units_.stress * stress.normal, units_.stress * stress.tangential};
}

Vector ContactFields::continuous() const {
  return withoutJumps(multiplierSpace(), solved_.problem.number(), multiplier_, bounds_);
}

ContactPoint ContactFields::at(const Element& element, double t) const {
  const MultiplierSpace& space = multiplierSpace();
  const auto stress = space.at(multiplier_, element, t);
  const ContactPlace here{solved_, element, t};
  const bem::Vec2 u = solved_.displacementAt(element.element, t);

  ContactPoint point;
  point.place = here.place;
  point.pressure = units_.stress * stress.normal;
  point.shear = units_.stress * stress.tangential;
  point.direction = here.opposite.direction;
  point.normal = units_.length * here.approach(u);
  point.tangential = units_.length * dot(u - here.motion, turnLeft(point.direction.unit));
  point.gap = units_.length * here.opposite.gap;
  if (element.condition->sliding)
    point.sliding = element.condition->sliding(point.place);
  point.closing = units_.length * here.closing(stress.normal);
  point.worn = units_.length * here.worn(&Wear::depth);
  if (solved_.wear != nullptr)
    point.distance =
        units_.length * space.throughPoints(solved_.wear->distance, element, t);
  point.closed = closing(element, stress) > 0;
  if (element.shears()) {
    point.bound = units_.stress * here.bound(stress.normal);
    const double bound = space.at(bounds_, element, t).tangential;
    if (element.ties() || bound > tolerance_)
      point.friction = slipping(element, stress.tangential, bound) <= 0
                           ? ContactState::Stick
                       : stress.tangential > 0 ? ContactState::SlipForward
                                               : ContactState::SlipBackward;
  }
  return point;
}

}  // namespace epafi::contact
