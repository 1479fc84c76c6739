#include "bem/base/Error.hpp"
#include "bem/base/Suggestion.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "drivers/scene/Readers.hpp"
#include "drivers/scene/Scene.hpp"

#include <Teuchos_Array.hpp>

#include <algorithm>

namespace epafi::drivers {

namespace {

using bem::InputError;

void readWear(const Part& part, contact::Conditions::Contact& condition) {
  condition.cycles = part.number("Cycle Jump");
  if (!(condition.cycles >= 1))
    throw InputError(part.path("Cycle Jump"), ": is ", condition.cycles,
                     " at t = ", part.names.t, "; a step happens once at least");
  if (!part.has("Coefficient"))
    return;
  if (condition.friction.ties())
    throw InputError(part.place.path,
                     ": bonded sides do not slip, so that they do not wear; take "
                     "another law of friction than Tied");
  if (!condition.friction && !condition.sliding)
    throw InputError(
        part.place.path,
        ": without friction the slip of the sides is not computed; take the law "
        "Coulomb, of Coefficient 0 if need be, or give Sliding");
  condition.wear = part.nonNegative("Coefficient");
}

/// Coulomb's Coefficient may depend on the pressure.
contact::Friction readFriction(const Part& part, const contact::FieldOf& fields) {
  if (part.list->get<std::string>("Law") == "Coulomb")
    if (const auto coefficient = part.ofPressure("Coefficient"); coefficient) {
      contact::Friction friction = contact::makePressureFriction(coefficient);
      if (part.has("Compliance"))
        friction.compliance = fields("Compliance");
      return friction;
    }
  return contact::parseFriction(*part.list, fields);
}

/// The parameters that all contacts have.
contact::Conditions::Contact readSurface(const Part& part) {
  const auto fieldsOf = [](const Part& law, bool orZero = true) {
    return [law, orZero](const std::string& key) { return law.nonNegative(key, orZero); };
  };
  contact::Conditions::Contact condition;
  condition.path = part.place.path;
  const Part friction = part.sub("Friction");
  condition.friction = readFriction(friction, fieldsOf(friction));
  if (part.has("Sliding")) {
    const bem::Function now = part.function("Sliding");
    const bem::Function before = part.then(0).function("Sliding");
    condition.sliding = [now, before](const bem::SurfacePoint& x) {
      return now(x) - before(x);
    };
  }
  readWear(part.sub("Wear"), condition);
  const Part normal = part.sub("Normal");
  condition.normal = contact::parseNormal(*normal.list, fieldsOf(normal));
  if (condition.normal && !condition.normal.law->isLinear())
    condition.normal = contact::parseNormal(*normal.list, fieldsOf(normal, false));
  return condition;
}

}  // namespace

contact::Conditions::Contact readContactOfBodies(const Part& part) {
  contact::Conditions::Contact condition = readSurface(part);
  condition.gap = [interference = part.function("Interference")](
                      const bem::SurfacePoint& x) { return -interference(x); };
  return condition;
}

void checkNamed(const std::string& boundary, const std::string& path,
                const bem::Outline& outline) {
  const std::vector<std::string> names = boundaryNames(outline);
  if (std::find(names.begin(), names.end(), boundary) == names.end())
    throw InputError(path, ": no edge has this name", bem::suggestion(boundary, names));
}

namespace {

/// Length of a boundary [length], or its area around the axis [length^2].
double lengthOf(const bem::Outline& outline, const std::string& boundary) {
  constexpr double turn = 6.2831853071795865;
  double length = 0;
  for (const bem::Edge& edge : outline.edges())
    if (edge.boundary == boundary)
      length += edge.curve.length() * outline.units(1).measure() *
                (outline.isAxisymmetric() ? turn * edge.curve.centroid().x : 1);
  return length;
}

bem::Function sum(const bem::Function& a, const bem::Function& b) {
  return a ? [a, b](const bem::SurfacePoint& x) { return a(x) + b(x); } : b;
}

/// Adds the traction M/I J(x - c), J a rotation by 90°, I = ∫ |x - c|², c the centroid.
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

/// The traction along an axis, "X" or "Y": as given, or uniform with the given force.
bem::Function readTraction(const Part& part, const std::string& axis, double length) {
  const std::string force = "Force " + axis;
  if (!part.has(force))
    return part.function("Traction " + axis);
  if (part.has("Traction " + axis))
    throw InputError(part.path(force), ": give this or Traction ", axis, ", not both");
  return [traction = part.number(force) / length](bem::Vec2) { return traction; };
}

void readBoundary(const Part& part, const std::string& boundary,
                  const bem::Outline& outline, contact::Conditions& conditions) {
  const std::string type = part.list->get<std::string>("Type");
  if (type == "Contact") {
    contact::Conditions::Contact& condition = conditions.contact[boundary] =
        readSurface(part);
    condition.gap = part.function("Gap");
    return;
  }
  if (type == "Dirichlet") {
    const bem::Function x = part.function("Displacement X");
    const bem::Function y = part.function("Displacement Y");
    const bem::Function normal = part.function("Displacement Normal");
    if (!x && !y && !normal)
      throw InputError(part.place.path,
                       ": a Dirichlet condition needs Displacement X, Displacement Y or "
                       "both, or Displacement Normal");
    if (normal && (x || y))
      throw InputError(part.path("Displacement Normal"),
                       ": stands in place of Displacement X and Displacement Y; give "
                       "this or these");
    if (normal) {
      contact::Conditions::Contact& support = conditions.contact[boundary];
      support.isSupport = true;
      support.gap = normal;
      support.path = part.path("Displacement Normal");
    } else {
      conditions.dirichlet[boundary] = {x, y};
    }
  }
  const double length = lengthOf(outline, boundary);
  contact::Conditions::Neumann load{readTraction(part, "X", length),
                                    readTraction(part, "Y", length)};
  if (part.has("Pressure")) {
    const bem::Function pressure = part.function("Pressure");
    load.x = sum(load.x, [pressure](const bem::SurfacePoint& x) {
      return -pressure(x) * x.normal.x;
    });
    load.y = sum(load.y, [pressure](const bem::SurfacePoint& x) {
      return -pressure(x) * x.normal.y;
    });
  }
  if (part.has("Moment"))
    addMoment(part.number("Moment"), outline, boundary, load);
  for (const char* axis : {"X", "Y"})
    if (part.has(std::string("Displacement ") + axis) && (*axis == 'X' ? load.x : load.y))
      throw InputError(part.place.path, "->Displacement ", axis,
                       ": a traction or a force along ", axis,
                       " is given, too; one of them moves the boundary, not both");
  if (type == "Neumann" || load.x || load.y)
    conditions.neumann[boundary] = load;
}

}  // namespace

contact::Conditions readConditions(const Part& body, const bem::Outline& outline,
                                   const Symmetry& symmetry) {
  contact::Conditions conditions;
  const Part all = body.sub("Boundary Conditions");
  for (const auto& item : *all.list) {
    Part part = all.sub(item.first);
    checkNamed(item.first, part.place.path, outline);
    part.names.onBoundary = true;
    readBoundary(part, item.first, outline, conditions);
  }
  const Part rigid = body.sub("Rigid Motions");
  conditions.fix.path = rigid.place.path;
  if (rigid.has("Fix"))
    for (const std::string& motion :
         rigid.list->get<Teuchos::Array<std::string>>("Fix")) {
      conditions.fix.x |= motion == "X";
      conditions.fix.y |= motion == "Y";
      conditions.fix.rotation |= motion == "Rotation";
    }
  for (std::size_t k = 0; k < outline.edges().size(); ++k)
    if (outline.isAxis(static_cast<int>(k))) {
      const std::string& axis = outline.edges()[k].boundary;
      conditions.symmetry.insert(axis);
      conditions.dirichlet[axis].x = [](bem::Vec2) { return 0.0; };
    }
  if (symmetry.cuts(outline)) {
    conditions.symmetry.insert(Symmetry::boundary);
    contact::Conditions::Dirichlet& roller = conditions.dirichlet[Symmetry::boundary];
    (symmetry.axis == 0 ? roller.x : roller.y) = [](bem::Vec2) { return 0.0; };
    (symmetry.axis == 0 ? conditions.fix.x : conditions.fix.y) = false;
    conditions.fix.rotation = false;
  }
  return conditions;
}

}  // namespace epafi::drivers
