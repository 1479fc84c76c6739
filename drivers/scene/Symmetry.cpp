#include "drivers/scene/Symmetry.hpp"

#include "bem/base/Error.hpp"
#include "bem/geometry/Crossing.hpp"

#include <Teuchos_Array.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace epafi::drivers {

namespace {

using bem::InputError;
using bem::Vec2;
using Teuchos::ParameterList;

/// Points closer to the line than this share of the diameter lie on it: coordinates in
/// files have 6 or 7 digits.
constexpr double near = 1e-6;

/// Moves vertices near the line onto it and renames edges there; returns their names.
std::set<std::string> align(const Symmetry& symmetry, double tolerance,
                            const std::string& path, bem::Loop& loop) {
  for (Vec2& v : loop.vertices)
    if (std::abs(symmetry.across(v)) <= tolerance)
      symmetry.across(v) = 0;
  std::set<std::string> renamed;
  const std::size_t count = loop.vertices.size();
  for (std::size_t i = 0; i < count; ++i) {
    std::string& name = loop.edges[i];
    if (symmetry.across(loop.vertices[i]) == 0 &&
        symmetry.across(loop.vertices[(i + 1) % count]) == 0 &&
        (loop.bulges.empty() || loop.bulges[i] == 0)) {
      renamed.insert(name);
      name = Symmetry::boundary;
    } else if (name == Symmetry::boundary) {
      throw InputError(path, ": edge ", i, " is named '", name,
                       "', as edges on the line of symmetry are, and lies off it "
                       "(Geometry->Symmetry); take another name");
    }
  }
  return renamed;
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

/// Edges on the line are rollers: no condition or contact may name them.
void checkUnnamed(const Symmetry& symmetry, const std::set<std::string>& names,
                  const std::string& body, const ParameterList& scene) {
  const auto refuse = [&](const std::string& path) {
    throw InputError(path, ": these edges lie on the line of symmetry, ", symmetry.line(),
                     " (Geometry->Symmetry); they are rollers by themselves, without "
                     "heat across; remove it");
  };
  for (const std::string& name : names) {
    for (const char* part : {"Boundary Conditions", "Thermal Conditions"})
      if (scene.sublist("Bodies").sublist(body).sublist(part).isParameter(name))
        refuse(bem::message("Bodies->", body, "->", part, "->", name));
    for (const auto& contact : scene.sublist("Contacts"))
      for (const std::string& side : scene.sublist("Contacts")
                                         .sublist(contact.first)
                                         .get<Teuchos::Array<std::string>>("Between"))
        if (side == body + ":" + name)
          refuse(bem::message("Contacts->", contact.first, "->Between: '", side, "'"));
  }
}

}  // namespace

bool Symmetry::cuts(const bem::Outline& outline) const {
  return axis >= 0 &&
         std::any_of(outline.edges().begin(), outline.edges().end(),
                     [](const bem::Edge& e) { return e.boundary == boundary; });
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
    std::set<std::string> onLine;
    std::set<std::string> others;
    const auto add = [&](bem::Loop& loop) {
      onLine.merge(align(symmetry, tolerance, path, loop));
      others.insert(loop.edges.begin(), loop.edges.end());
      side = sideOf(symmetry, tolerance, side, path, loop);
    };
    add(own->outer);
    for (bem::Loop& hole : own->holes)
      add(hole);
    touches = touches || !onLine.empty();
    others.erase(Symmetry::boundary);
    for (const std::string& name : others)
      onLine.erase(name);
    onLine.insert(Symmetry::boundary);
    checkUnnamed(symmetry, onLine, item.first, scene);
    ++own;
  }
  if (!touches)
    throw InputError("Geometry->Symmetry: no edge of a body lies on the line ",
                     symmetry.line(), "; at least one body is cut by it");
  return loops;
}

}  // namespace epafi::drivers
