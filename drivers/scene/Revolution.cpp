#include "drivers/scene/Revolution.hpp"

#include "bem/base/Error.hpp"
#include "bem/geometry/Crossing.hpp"
#include "drivers/scene/Scene.hpp"
#include "drivers/scene/Symmetry.hpp"

#include <Teuchos_Array.hpp>

#include <algorithm>
#include <cmath>

namespace epafi::drivers {

namespace {

using bem::InputError;
using bem::Vec2;
using Teuchos::ParameterList;

constexpr const char* type = "Geometry->Type = Axisymmetric";

/// Points closer to the axis than this share of the diameter lie on it.
constexpr double near = 1e-6;

bool isOnAxis(const bem::Loop& loop, std::size_t edge) {
  const std::size_t next = (edge + 1) % loop.vertices.size();
  return loop.vertices[edge].x == 0 && loop.vertices[next].x == 0 &&
         (loop.bulges.empty() || loop.bulges[edge] == 0);
}

void checkSide(const bem::Loop& loop, double tolerance, const std::string& path) {
  for (std::size_t i = 0; i < loop.vertices.size(); ++i)
    for (const Vec2 point : extent(loop.curve(i)))
      if (point.x < -tolerance)
        throw InputError(path, ": the point (", point.x, ", ", point.y,
                         ") lies beyond the axis x = 0; with ", type,
                         " x is the radius, and x >= 0");
}

/// Removes vertices between two edges on the axis.
void joinEdges(bem::Loop& loop) {
  for (std::size_t i = 0; i < loop.vertices.size();) {
    const std::size_t before = (i + loop.vertices.size() - 1) % loop.vertices.size();
    if (!isOnAxis(loop, before) || !isOnAxis(loop, i)) {
      ++i;
      continue;
    }
    const auto at = static_cast<std::ptrdiff_t>(i);
    loop.vertices.erase(loop.vertices.begin() + at);
    loop.edges.erase(loop.edges.begin() + at);
    if (!loop.bulges.empty())
      loop.bulges.erase(loop.bulges.begin() + at);
  }
}

void alignLoop(bem::Loop& loop, double tolerance, const std::string& path,
               std::vector<std::string>& onAxis) {
  checkSide(loop, tolerance, path);
  for (Vec2& v : loop.vertices)
    if (std::abs(v.x) <= tolerance)
      v.x = 0;
  joinEdges(loop);
  const std::size_t size = loop.vertices.size();
  for (std::size_t i = 0; i < size; ++i) {
    if (loop.vertices[i].x == 0 && !isOnAxis(loop, i) &&
        !isOnAxis(loop, (i + size - 1) % size))
      throw InputError(path, ": the body meets the axis at the point (0, ",
                       loop.vertices[i].y,
                       ") alone; it has an edge on the axis, or keeps off it");
    if (isOnAxis(loop, i)) {
      onAxis.push_back(loop.edges[i]);
      loop.edges[i] = axisBoundary;
    } else if (loop.edges[i] == axisBoundary) {
      throw InputError(path, ": edge ", i, " is named '", axisBoundary,
                       "', as edges on the axis x = 0 are, and lies off it; take another "
                       "name");
    }
  }
}

bool isIn(const bem::Loops& loops, const std::string& name) {
  const auto has = [&](const bem::Loop& loop) {
    return std::find(loop.edges.begin(), loop.edges.end(), name) != loop.edges.end();
  };
  return has(loops.outer) || std::any_of(loops.holes.begin(), loops.holes.end(), has);
}

}  // namespace

std::vector<bem::Loops> alignedWithAxis(std::vector<bem::Loops> loops,
                                        const ParameterList& scene) {
  auto own = loops.begin();
  for (const auto& item : scene.sublist("Bodies")) {
    const std::string path = "Bodies->" + item.first + "->Geometry";
    const double tolerance = near * bem::scalingOf(own->outer).length;
    std::vector<std::string> onAxis = {axisBoundary};
    alignLoop(own->outer, tolerance, path, onAxis);
    for (bem::Loop& hole : own->holes)
      alignLoop(hole, tolerance, path, onAxis);
    for (const std::string& name : onAxis)
      if (name == axisBoundary || !isIn(*own, name))
        requireUnnamed(scene, item.first, name,
                       bem::message("lie on the axis x = 0 (", type,
                                    "), where nothing can act; remove it"));
    ++own;
  }
  return loops;
}

namespace {

/// What a list of the scene must not have, and why.
void refuse(const Part& part, std::initializer_list<const char*> keys,
            const std::string& why) {
  for (const char* key : keys)
    if (part.list->isParameter(key) && !part.list->getEntry(key).isDefault())
      throw InputError(part.path(key), ": ", type, ": ", why);
}

void checkBodyLoads(const Part& loads) {
  refuse(loads, {"Gravity X"},
         "weight acts along the axis, Gravity Y; a force outwards is Force X");
  refuse(loads, {"Angular Acceleration"},
         "twists the section out of its plane; solids of revolution are without torsion");
  refuse(loads, {"Center"}, "Spin is about the axis; remove this key");
}

void checkBody(const Part& body) {
  constexpr const char* along =
      "the only rigid motion is along the axis: Y; remove this key";
  refuse(body.sub("Material"), {"Plane State"},
         "a solid of revolution is in no plane state; remove this key");
  const Part motion = body.sub("Motion");
  refuse(motion,
         {"Displacement X", "Rotation", "Force X", "Moment", "Stiffness X",
          "Stiffness Rotation"},
         along);
  const Part rigid = body.sub("Rigid Motions");
  if (rigid.has("Fix"))
    for (const std::string& name : rigid.list->get<Teuchos::Array<std::string>>("Fix"))
      if (name != "Y")
        throw InputError(
            rigid.path("Fix"), ": ", type, ": '", name,
            "' is not a rigid motion of a solid of revolution; Y is the only one");
  checkBodyLoads(body.sub("Body Loads"));
  const Part conditions = body.sub("Boundary Conditions");
  for (const auto& item : *conditions.list)
    refuse(
        conditions.sub(item.first), {"Force X", "Moment"},
        "forces across the axis and moments cancel around it; give Traction X, per area");
}

}  // namespace

bool parseRevolution(const ParameterList& geometry) {
  const bool isAxisymmetric = geometry.get<std::string>("Type") == "Axisymmetric";
  if (isAxisymmetric && geometry.get<std::string>("Symmetry") == "X")
    throw InputError("Geometry->Symmetry: ", type,
                     ": a section is drawn for x >= 0 anyway; Y and None are possible");
  return isAxisymmetric;
}

void checkRevolution(const Scene& scene) {
  const Part root = scene.root();
  for (const auto& item : *root.sub("Bodies").list)
    checkBody(root.sub("Bodies").sub(item.first));
  checkBodyLoads(root.sub("Body Loads"));
  if (scene.stabilization.tractions())
    throw InputError("Discretization->Stabilization->Form: ", type,
                     ": evaluates plane tractions; Density and None are possible");
  if (scene.multiplier != "Gauss-Legendre-Lagrange")
    throw InputError(
        "Discretization->Multiplier: ", type, ": ", scene.multiplier,
        " knows no weights by the radius; Gauss-Legendre-Lagrange is possible");
}

}  // namespace epafi::drivers
