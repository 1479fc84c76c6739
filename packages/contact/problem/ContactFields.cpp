#include "contact/problem/ContactFields.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::contact {

namespace {

constexpr double stateTolerance = 1e-9;  // of the load; Newton stops far below

Vector boundsAsCoefficients(const Problem& numbers, const Vector& multiplier) {
  Vector result(static_cast<std::size_t>(numbers.normals), 0.0);
  const Vector bounds = numbers.slipBounds(multiplier);
  result.insert(result.end(), bounds.begin(), bounds.end());
  return result;
}

}  // namespace

ContactFields::ContactFields(const ContactProblem& problem, const bem::Space& space,
                             bem::Units units, const State& state,
                             const Vector& displacement)
    : problem_(problem),
      space_(space),
      units_(units),
      multiplier_(state.multiplier),
      displacement_(displacement),
      bounds_(boundsAsCoefficients(problem.numbers(), state.multiplier)),
      tolerance_(stateTolerance * problem.numbers().stress) {}

double ContactFields::closing(const Element& element, double t) const {
  return problem_.multiplier().at(multiplier_, element, t).normal - tolerance_;
}

double ContactFields::discreteBound(const Element& element, double t) const {
  return units_.stress * problem_.multiplier().at(bounds_, element, t).tangential;
}

double ContactFields::slipping(const Element& element, double t) const {
  if (element.tangential < 0)
    return -tolerance_;
  const double bound = problem_.multiplier().at(bounds_, element, t).tangential;
  if (bound <= tolerance_)
    return -tolerance_;
  const double shear = problem_.multiplier().at(multiplier_, element, t).tangential;
  return std::abs(shear) - bound + tolerance_;
}

ContactPoint ContactFields::at(const Element& element, double t) const {
  const MultiplierSpace& space = problem_.multiplier();
  const auto stress = space.at(multiplier_, element, t);
  const bem::Element& geometry = space_.mesh()[element.element];
  const bem::Vec2 u = space_.displacementAt(displacement_, element.element, t);

  ContactPoint point;
  point.place = space_.mesh().physicalPoint(element.element, t);
  point.pressure = units_.stress * stress.normal;
  point.shear = units_.stress * stress.tangential;
  point.normal = units_.length * dot(u, geometry.curve.normal(t));
  point.tangential = units_.length * dot(u, geometry.curve.tangent(t));
  const Conditions::Contact& condition = *element.condition;
  point.gap = condition.gap ? condition.gap(point.place) : 0;
  point.closed = closing(element, t) > 0;
  if (element.tangential >= 0) {
    point.bound = units_.stress *
                  condition.friction.at(point.place, units_.stress).bound(stress.normal);
    if (space.at(bounds_, element, t).tangential > tolerance_)
      point.friction =
          slipping(element, t) > 0 ? FrictionKind::Slip : FrictionKind::Stick;
  }
  return point;
}

}  // namespace epafi::contact
