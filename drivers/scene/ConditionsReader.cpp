#include "drivers/scene/ConditionsReader.hpp"

#include "bem/base/Error.hpp"
#include "bem/base/Parameters.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>

#include <algorithm>

namespace epafi::drivers {

namespace {

using bem::InputError;
using bem::message;
using Teuchos::ParameterList;

/// A list of the scene, and the time at which its expressions are taken.
struct Where {
  Place place;
  double t = 1;

  Where under(const std::string& key) const {
    return {{place.file, place.path + "->" + key}, t};
  }
};

/// The expression under a key; an empty function if it is not given.
bem::Function readFunction(const ParameterList& list, const std::string& key,
                           const Where& where) {
  if (!list.isParameter(key))
    return {};
  return makeExpression(list.get<std::string>(key), where.under(key).place, where.t);
}

/// A bound on the shear cannot be negative.
bem::Function nonNegative(const bem::Function& function, const Place& place) {
  return [function, place](bem::Vec2 point) {
    const double value = function(point);
    if (value < 0)
      throw InputError(message(place.file, ": ", place.path, " is ", value,
                               " at (x, y) = (", point.x, ", ", point.y,
                               "); it must be >= 0 there"));
    return value;
  };
}

contact::Friction readFriction(const ParameterList& list, const Where& where) {
  const ParameterList& friction = list.sublist("Friction");
  const Where inner = where.under("Friction");
  return contact::parseFriction(friction, [&](const std::string& key) {
    return nonNegative(readFunction(friction, key, inner), inner.under(key).place);
  });
}

contact::Conditions::Contact readContact(const ParameterList& list, const Where& where) {
  contact::Conditions::Contact condition;
  condition.gap = readFunction(list, "Gap", where);
  condition.friction = readFriction(list, where);
  return condition;
}

}  // namespace

contact::Conditions::Contact readContactOfBodies(const ParameterList& list,
                                                 const Place& place, double t) {
  contact::Conditions::Contact condition;
  const bem::Function interference = readFunction(list, "Interference", {place, t});
  condition.gap = [interference](bem::Vec2 x) { return -interference(x); };
  condition.friction = readFriction(list, {place, t});
  return condition;
}

void checkNamed(const std::string& boundary, const std::string& path,
                const bem::Outline& outline) {
  std::vector<std::string> names;
  for (const bem::Edge& edge : outline.edges())
    if (std::find(names.begin(), names.end(), edge.boundary) == names.end())
      names.push_back(edge.boundary);
  if (std::find(names.begin(), names.end(), boundary) == names.end())
    throw InputError(message(path, ": no edge has this name; did you mean '",
                             bem::nearest(boundary, names),
                             "'? named edges: ", bem::quotedList(names)));
}

namespace {

void readBoundary(const ParameterList& list, const std::string& boundary,
                  const Where& where, contact::Conditions& conditions) {
  const std::string type = list.get<std::string>("Type");
  if (type == "Dirichlet") {
    const bem::Function x = readFunction(list, "Displacement X", where);
    const bem::Function y = readFunction(list, "Displacement Y", where);
    if (!x && !y)
      throw InputError(where.place.path +
                       ": a Dirichlet condition needs Displacement X, "
                       "Displacement Y or both");
    conditions.dirichlet[boundary] = {x, y};
  } else if (type == "Neumann") {
    conditions.neumann[boundary] = {readFunction(list, "Traction X", where),
                                    readFunction(list, "Traction Y", where)};
  } else {
    conditions.contact[boundary] = readContact(list, where);
  }
}

}  // namespace

contact::Conditions readConditions(const ParameterList& body, const Place& place,
                                   const bem::Outline& outline, double t) {
  contact::Conditions conditions;
  const std::string path = place.path + "->Boundary Conditions";
  const ParameterList& list = body.sublist("Boundary Conditions");
  for (const auto& item : list) {
    const Place inner{place.file, path + "->" + item.first};
    checkNamed(item.first, inner.path, outline);
    readBoundary(list.sublist(item.first), item.first, {inner, t}, conditions);
  }
  const ParameterList& rigid = body.sublist("Rigid Motions");
  if (rigid.isParameter("Fix"))
    for (const std::string& motion : rigid.get<Teuchos::Array<std::string>>("Fix")) {
      conditions.fix.x |= motion == "X";
      conditions.fix.y |= motion == "Y";
      conditions.fix.rotation |= motion == "Rotation";
    }
  return conditions;
}

}  // namespace epafi::drivers
