#include "drivers/scene/Symmetry.hpp"

#include "bem/base/Error.hpp"
#include "bem/geometry/Crossing.hpp"

#include <Teuchos_Array.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace epafi::drivers {

namespace {

using bem::InputError;
using bem::Vec2;
using Teuchos::ParameterList;

/// Points closer to the line than this share of the diameter lie on it: coordinates in
/// files have 6 or 7 digits.
constexpr double near = 1e-6;

bool isOnLine(const Symmetry& symmetry, const bem::Loop& loop, std::size_t edge) {
  bem::Vec2 start = loop.vertices[edge];
  bem::Vec2 end = loop.vertices[(edge + 1) % loop.vertices.size()];
  return symmetry.across(start) == 0 && symmetry.across(end) == 0 &&
         (loop.bulges.empty() || loop.bulges[edge] == 0);
}

using Names = std::set<std::string>;

/// The names of a body's edges on the line, and of those off it.
struct Sides {
  Names on;
  Names off;
};

/// Moves vertices near the line onto it.
void align(const Symmetry& symmetry, double tolerance, bem::Loop& loop, Sides& names) {
  for (Vec2& v : loop.vertices)
    if (std::abs(symmetry.across(v)) <= tolerance)
      symmetry.across(v) = 0;
  for (std::size_t i = 0; i < loop.edges.size(); ++i)
    (isOnLine(symmetry, loop, i) ? names.on : names.off).insert(loop.edges[i]);
}

/// Does a boundary condition or a contact name a boundary?
bool hasCondition(const ParameterList& scene, const std::string& body,
                  const std::string& boundary) {
  if (scene.sublist("Bodies")
          .sublist(body)
          .sublist("Boundary Conditions")
          .isParameter(boundary))
    return true;
  const ParameterList& contacts = scene.sublist("Contacts");
  return std::any_of(contacts.begin(), contacts.end(), [&](const auto& contact) {
    const auto& sides = contacts.sublist(contact.first)
                            .template get<Teuchos::Array<std::string>>("Between");
    return std::find(sides.begin(), sides.end(), body + ":" + boundary) != sides.end();
  });
}

/// Does a boundary meet a rigid obstacle, on the line the image of its body?
bool meetsObstacle(const ParameterList& scene, const std::string& body,
                   const std::string& boundary) {
  const ParameterList& conditions =
      scene.sublist("Bodies").sublist(body).sublist("Boundary Conditions");
  return conditions.isSublist(boundary) &&
         conditions.sublist(boundary).get<std::string>("Type") == "Contact";
}

/// The boundaries on the line that are rollers: `symmetry` and `any`; without such those
/// without a condition, or whose condition is for edges off the line; without such all
/// but obstacles, to be refused: a load or support alone does not tell a half from a copy.
Names rollersOf(const ParameterList& scene, const std::string& body, const Sides& names) {
  Names rollers;
  const auto orElse = [&](const auto& isRoller) {
    if (rollers.empty())
      std::copy_if(names.on.begin(), names.on.end(),
                   std::inserter(rollers, rollers.end()), isRoller);
  };
  orElse([](const std::string& name) {
    return name == Symmetry::boundary || name == Symmetry::unnamed;
  });
  orElse([&](const std::string& name) {
    return names.off.count(name) > 0 || !hasCondition(scene, body, name);
  });
  orElse([&](const std::string& name) { return !meetsObstacle(scene, body, name); });
  return rollers;
}

/// Renames the rollers on the line.
void rename(const Symmetry& symmetry, const Names& rollers, const std::string& path,
            bem::Loop& loop) {
  for (std::size_t i = 0; i < loop.edges.size(); ++i) {
    std::string& name = loop.edges[i];
    if (isOnLine(symmetry, loop, i)) {
      if (rollers.count(name) > 0)
        name = Symmetry::boundary;
    } else if (name == Symmetry::boundary) {
      throw InputError(path, ": edge ", i, " is named '", name,
                       "', as edges on the line of symmetry are, and lies off it "
                       "(Geometry->Symmetry); take another name");
    }
  }
}

/// The side of the line where a polygon lies, -1 or 1; `side`: as required, 0: any.
double sideOf(const Symmetry& symmetry, double tolerance, double side,
              const std::string& path, const bem::Loop& loop) {
  for (std::size_t i = 0; i < loop.vertices.size(); ++i)
    for (Vec2 point : extent(loop.curve(i))) {
      const double across = symmetry.across(point);
      if (side * across < -tolerance)
        throw InputError(path, ": the point (", point.x, ", ", point.y,
                         ") lies beyond the line of symmetry, ", symmetry.line(),
                         "; with Geometry->Symmetry one half of the scene is drawn, all "
                         "of it on one side");
      if (side == 0 && std::abs(across) > tolerance)
        side = across < 0 ? -1 : 1;
    }
  return side;
}

}  // namespace

bool Symmetry::cuts(const bem::Outline& outline) const {
  return axis >= 0 &&
         std::any_of(outline.edges().begin(), outline.edges().end(),
                     [](const bem::Edge& e) { return e.boundary == boundary; });
}

void requireUnnamed(const ParameterList& scene, const std::string& body,
                    const std::string& boundary, const std::string& why) {
  const auto refuse = [&](const std::string& path) {
    throw InputError(path, ": these edges ", why);
  };
  for (const char* part : {"Boundary Conditions", "Thermal Conditions"})
    if (scene.sublist("Bodies").sublist(body).sublist(part).isParameter(boundary))
      refuse(bem::message("Bodies->", body, "->", part, "->", boundary));
  for (const auto& contact : scene.sublist("Contacts"))
    for (const std::string& side : scene.sublist("Contacts")
                                       .sublist(contact.first)
                                       .get<Teuchos::Array<std::string>>("Between"))
      if (side == body + ":" + boundary)
        refuse(bem::message("Contacts->", contact.first, "->Between: '", side, "'"));
}

Symmetry parseSymmetry(const ParameterList& geometry) {
  const auto& name = geometry.get<std::string>("Symmetry");
  return {name == "X" ? 0 : name == "Y" ? 1 : -1};
}

std::vector<bem::Loops> alignedWith(const Symmetry& symmetry,
                                    std::vector<bem::Loops> loops,
                                    const ParameterList& scene) {
  if (!symmetry)
    return loops;
  double side = 0;
  bool touches = false;
  auto own = loops.begin();
  for (const auto& item : scene.sublist("Bodies")) {
    const std::string path = "Bodies->" + item.first + "->Geometry";
    const double tolerance = near * bem::scalingOf(own->outer).length;
    const auto forEachLoop = [&](const auto& visit) {
      visit(own->outer);
      for (bem::Loop& hole : own->holes)
        visit(hole);
    };
    Sides names;
    forEachLoop([&](bem::Loop& loop) {
      align(symmetry, tolerance, loop, names);
      side = sideOf(symmetry, tolerance, side, path, loop);
    });
    touches = touches || !names.on.empty();
    Names rollers = rollersOf(scene, item.first, names);
    forEachLoop([&](bem::Loop& loop) { rename(symmetry, rollers, path, loop); });
    for (const std::string& name : names.off)
      rollers.erase(name);
    rollers.insert(Symmetry::boundary);
    for (const std::string& name : rollers)
      requireUnnamed(
          scene, item.first, name,
          bem::message("lie on the line of symmetry, ", symmetry.line(),
                       " (Geometry->Symmetry); they are rollers by themselves, "
                       "without heat across; remove it, or leave a gap to the "
                       "line if the body is one of two mirrored copies"));
    ++own;
  }
  if (!touches)
    throw InputError("Geometry->Symmetry: no edge of a body lies on the line ",
                     symmetry.line(), "; at least one body is cut by it");
  return loops;
}

}  // namespace epafi::drivers
