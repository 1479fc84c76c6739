#include "drivers/scene/ConditionsReader.hpp"

#include "bem/base/Error.hpp"
#include "bem/base/Suggestion.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "drivers/scene/Scene.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>

#include <algorithm>

namespace epafi::drivers {

namespace {

using bem::InputError;
using Teuchos::ParameterList;

/// A list of the scene, and what its expressions know.
struct Where {
  Place place;
  Names names;

  Where under(const std::string& key) const {
    return {{place.file, place.path + "->" + key}, names};
  }
};

/// The expression under a key; an empty function if it is not given.
bem::Function readFunction(const ParameterList& list, const std::string& key,
                           const Where& where) {
  if (!list.isParameter(key))
    return {};
  return makeExpression(list.get<std::string>(key), where.under(key).place, where.names);
}

/// A bound on the shear cannot be negative.
bem::Function nonNegative(const bem::Function& function, const Place& place, double t) {
  return [function, place, t](bem::Vec2 point) {
    const double value = function(point);
    if (value < 0)
      throw InputError(place.file, ": ", place.path, " is ", value, " at (x, y) = (",
                       point.x, ", ", point.y, ")",
                       t == 1 ? "" : bem::message(", t = ", t),
                       "; it must be >= 0 there");
    return value;
  };
}

contact::Friction readFriction(const ParameterList& list, const Where& where) {
  const ParameterList& friction = list.sublist("Friction");
  const Where inner = where.under("Friction");
  return contact::parseFriction(friction, [&](const std::string& key) {
    return nonNegative(readFunction(friction, key, inner), inner.under(key).place,
                       where.names.t);
  });
}

void readWear(const ParameterList& list, const Where& where,
              contact::Conditions::Contact& condition) {
  const Place jump = where.under("Cycle Jump").place;
  condition.cycles =
      evaluateAt(where.names.t, list.get<std::string>("Cycle Jump"), jump, where.names);
  if (!(condition.cycles >= 1))
    throw InputError(jump.path, ": is ", condition.cycles, " at t = ", where.names.t,
                     "; a step happens once at least");
  const bem::Function coefficient = readFunction(list, "Coefficient", where);
  if (!coefficient)
    return;
  if (condition.friction.ties())
    throw InputError(where.place.path,
                     ": bonded sides do not slip, so that they do not wear; take "
                     "another law of friction than Tied");
  condition.wear =
      nonNegative(coefficient, where.under("Coefficient").place, where.names.t);
}

/// What all contacts have.
contact::Conditions::Contact readSurface(const ParameterList& list, const Where& where) {
  contact::Conditions::Contact condition;
  condition.friction = readFriction(list, where);
  if (list.isParameter("Sliding")) {
    Where start = where;
    start.names.t = 0;
    const bem::Function now = readFunction(list, "Sliding", where);
    const bem::Function before = readFunction(list, "Sliding", start);
    condition.sliding = [now, before](bem::Vec2 x) { return now(x) - before(x); };
  }
  readWear(list.sublist("Wear"), where.under("Wear"), condition);
  const ParameterList& normal = list.sublist("Normal");
  const Where inner = where.under("Normal");
  condition.normal = contact::parseNormal(normal, [&](const std::string& key) {
    return nonNegative(readFunction(normal, key, inner), inner.under(key).place,
                       where.names.t);
  });
  return condition;
}

contact::Conditions::Contact readContact(const ParameterList& list, const Where& where) {
  contact::Conditions::Contact condition = readSurface(list, where);
  condition.gap = readFunction(list, "Gap", where);
  return condition;
}

}  // namespace

contact::Conditions::Contact readContactOfBodies(const ParameterList& list,
                                                 const Place& place, const Names& names) {
  contact::Conditions::Contact condition = readSurface(list, {place, names});
  const bem::Function interference = readFunction(list, "Interference", {place, names});
  condition.gap = [interference](bem::Vec2 x) { return -interference(x); };
  return condition;
}

void checkNamed(const std::string& boundary, const std::string& path,
                const bem::Outline& outline) {
  const std::vector<std::string> names = boundaryNames(outline);
  if (std::find(names.begin(), names.end(), boundary) == names.end())
    throw InputError(path, ": no edge has this name", bem::suggestion(boundary, names));
}

std::function<bem::Vec2(bem::Vec2)> normalOn(const bem::Outline& outline,
                                             const std::string& boundary) {
  std::vector<bem::Curve> curves;
  for (const bem::Edge& edge : outline.edges())
    if (edge.boundary == boundary)
      curves.push_back(edge.curve);
  return [curves, scaling = outline.scaling()](bem::Vec2 physical) {
    const bem::Vec2 x = (1 / scaling.length) * (physical - scaling.origin);
    const auto nearest = std::min_element(curves.begin(), curves.end(),
                                          [x](const bem::Curve& a, const bem::Curve& b) {
                                            return a.distance(x) < b.distance(x);
                                          });
    return nearest->normal(std::clamp(nearest->seen(x).z().real(), -1.0, 1.0));
  };
}

namespace {

/// [length]
double lengthOf(const bem::Outline& outline, const std::string& boundary) {
  double length = 0;
  for (const bem::Edge& edge : outline.edges())
    if (edge.boundary == boundary)
      length += edge.curve.length() * outline.scaling().length;
  return length;
}

bem::Function sum(const bem::Function& a, const bem::Function& b) {
  return a ? [a, b](bem::Vec2 x) { return a(x) + b(x); } : b;
}

/// Adds the traction M/I J(x - c), I = ∫ |x - c|², c the boundary's centroid.
void addMoment(double moment, const bem::Outline& outline, const std::string& boundary,
               contact::Conditions::Neumann& load) {
  const bem::Rule& rule = bem::gaussLegendre(20);
  const auto integral = [&](const auto& function) {
    auto sum = 0 * function(bem::Vec2{});
    for (const bem::Edge& edge : outline.edges())
      for (int q = 0; edge.boundary == boundary && q < rule.size(); ++q)
        sum = sum +
              (0.5 * edge.curve.length() * outline.scaling().length * rule.weights[q]) *
                  function(outline.physical(edge.curve.point(rule.points[q])));
    return sum;
  };
  const bem::Vec2 c =
      (1 / lengthOf(outline, boundary)) * integral([](bem::Vec2 x) { return x; });
  const double turn = moment / integral([c](bem::Vec2 x) { return dot(x - c, x - c); });
  load.x = sum(load.x, [turn, c](bem::Vec2 x) { return -turn * (x.y - c.y); });
  load.y = sum(load.y, [turn, c](bem::Vec2 x) { return turn * (x.x - c.x); });
}

double readNumber(const ParameterList& list, const std::string& key, const Where& where) {
  return evaluateAt(where.names.t, list.get<std::string>(key), where.under(key).place,
                    where.names);
}

/// Along one axis, "X" or "Y": as given, or the uniform one of a given force.
bem::Function readTraction(const ParameterList& list, const std::string& axis,
                           const Where& where, double length) {
  const std::string force = "Force " + axis;
  if (!list.isParameter(force))
    return readFunction(list, "Traction " + axis, where);
  if (list.isParameter("Traction " + axis))
    throw InputError(where.under(force).place.path, ": give this or Traction ", axis,
                     ", not both");
  const double traction = readNumber(list, force, where) / length;
  return [traction](bem::Vec2) { return traction; };
}

void readBoundary(const ParameterList& list, const std::string& boundary,
                  const Where& where, const bem::Outline& outline,
                  contact::Conditions& conditions) {
  const std::string type = list.get<std::string>("Type");
  if (type == "Dirichlet") {
    const bem::Function x = readFunction(list, "Displacement X", where);
    const bem::Function y = readFunction(list, "Displacement Y", where);
    if (!x && !y)
      throw InputError(
          where.place.path +
          ": a Dirichlet condition needs Displacement X, Displacement Y or both");
    conditions.dirichlet[boundary] = {x, y};
  }
  if (type != "Contact") {
    const double length = lengthOf(outline, boundary);
    contact::Conditions::Neumann load{readTraction(list, "X", where, length),
                                      readTraction(list, "Y", where, length)};
    if (list.isParameter("Moment"))
      addMoment(readNumber(list, "Moment", where), outline, boundary, load);
    for (const char* axis : {"X", "Y"})
      if (list.isParameter(std::string("Displacement ") + axis) &&
          (*axis == 'X' ? load.x : load.y))
        throw InputError(where.place.path, "->Displacement ", axis,
                         ": a traction or a force along ", axis,
                         " is given, too; one of them moves the boundary, not both");
    if (type == "Neumann" || load.x || load.y)
      conditions.neumann[boundary] = load;
  } else {
    conditions.contact[boundary] = readContact(list, where);
  }
}

}  // namespace

contact::Conditions readConditions(const ParameterList& body, const Place& place,
                                   const bem::Outline& outline, const Symmetry& symmetry,
                                   const Names& names) {
  contact::Conditions conditions;
  const std::string path = place.path + "->Boundary Conditions";
  const ParameterList& list = body.sublist("Boundary Conditions");
  for (const auto& item : list) {
    const Place inner{place.file, path + "->" + item.first};
    checkNamed(item.first, inner.path, outline);
    Names here = names;
    here.normal = normalOn(outline, item.first);
    readBoundary(list.sublist(item.first), item.first, {inner, here}, outline,
                 conditions);
  }
  const ParameterList& rigid = body.sublist("Rigid Motions");
  conditions.fix.path = place.path + "->Rigid Motions";
  if (rigid.isParameter("Fix"))
    for (const std::string& motion : rigid.get<Teuchos::Array<std::string>>("Fix")) {
      conditions.fix.x |= motion == "X";
      conditions.fix.y |= motion == "Y";
      conditions.fix.rotation |= motion == "Rotation";
    }
  if (symmetry.cuts(outline)) {
    conditions.symmetry = {Symmetry::boundary};
    contact::Conditions::Dirichlet& roller = conditions.dirichlet[Symmetry::boundary];
    (symmetry.axis == 0 ? roller.x : roller.y) = [](bem::Vec2) { return 0.0; };
    (symmetry.axis == 0 ? conditions.fix.x : conditions.fix.y) = false;
    conditions.fix.rotation = false;
  }
  return conditions;
}

}  // namespace epafi::drivers
