#include "drivers/scene/BodiesReader.hpp"

#include "bem/base/Error.hpp"
#include "drivers/scene/BodyLoadsReader.hpp"
#include "drivers/scene/ConditionsReader.hpp"
#include "drivers/scene/Expression.hpp"
#include "drivers/scene/GeometryReader.hpp"
#include "drivers/scene/MeshReader.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>

#include <algorithm>
#include <array>
#include <limits>

namespace epafi::drivers {

namespace {

using bem::InputError;
using Teuchos::ParameterList;

bem::Material readMaterial(const ParameterList& list, const std::string& path) {
  for (const char* key : {"Young's Modulus", "Poisson's Ratio"})
    if (!list.isParameter(key))
      throw InputError(path, "->", key,
                       ": missing; every body that is not Rigid has one");
  bem::Material material;
  material.youngsModulus = list.get<double>("Young's Modulus");
  material.poissonsRatio = list.get<double>("Poisson's Ratio");
  material.planeStress = list.get<std::string>("Plane State") == "Plane Stress";
  return material;
}

void refuseMotion(const ParameterList& motion, const std::string& path) {
  for (const auto& item : motion)
    if (!item.second.isDefault())
      throw InputError(path, "->Motion->", item.first,
                       ": belongs to a body with Material->Rigid = true; others "
                       "have Boundary Conditions and Rigid Motions");
}

Body readBody(ParameterList& list, const std::string& name, const Scene& scene,
              const bem::Loops& loops, double length,
              const ParameterList& discretization) {
  const std::string path = "Bodies->" + name;
  Body body;
  body.name = name;
  body.material = readMaterial(list.sublist("Material"), path + "->Material");
  refuseMotion(list.sublist("Motion"), path);
  body.outline = makeOutline(loops, length, path + "->Geometry");
  body.conditions = readConditions(list, {scene.file, path}, *body.outline,
                                   scene.symmetry, scene.names());
  readMesh(list.sublist("Mesh"), discretization, path, body);
  return body;
}

void refuseElasticity(const ParameterList& list, const std::string& path) {
  const auto refuse = [&](const std::string& key) {
    throw InputError(path, "->", key,
                     ": the body is rigid (Material->Rigid = true); it has "
                     "Geometry, Motion and what acts on mass alone");
  };
  for (const char* key : {"Young's Modulus", "Poisson's Ratio"})
    if (list.sublist("Material").isParameter(key))
      refuse(std::string("Material->") + key);
  for (const char* part :
       {"Boundary Conditions", "Mesh", "Rigid Motions", "Thermal Conditions"})
    for (const auto& item : list.sublist(part))
      if (!item.second.isDefault())
        refuse(std::string(part) + "->" + item.first);
}

bem::Vec2 centroidOf(const bem::Outline& outline, const Symmetry& symmetry) {
  bem::Vec2 sum;
  double length = 0;
  for (const bem::Edge& edge : outline.edges()) {
    if (symmetry && edge.boundary == Symmetry::boundary)
      continue;
    sum = sum + edge.curve.length() * edge.curve.centroid();
    length += edge.curve.length();
  }
  bem::Vec2 centroid = outline.physical((1 / length) * sum);
  if (symmetry.cuts(outline))
    symmetry.across(centroid) = 0;
  return centroid;
}

bem::Vec2 readPole(const ParameterList& motion, const std::string& path,
                   const bem::Outline& outline, const Symmetry& symmetry) {
  if (!motion.isParameter("Reference Point"))
    return centroidOf(outline, symmetry);
  const auto& point = motion.get<Teuchos::Array<double>>("Reference Point");
  if (point.size() != 2)
    throw InputError(path, ": has ", point.size(), " numbers; a point has two");
  return {point[0], point[1]};
}

RigidBody readRigid(const ParameterList& list, const std::string& name,
                    const Scene& scene, const bem::Loops& loops) {
  const std::string path = "Bodies->" + name;
  refuseElasticity(list, path);
  RigidBody body;
  body.name = name;
  body.outline = makeOutline(loops, 0, path + "->Geometry");
  const ParameterList& motion = list.sublist("Motion");
  body.pole =
      readPole(motion, path + "->Motion->Reference Point", *body.outline, scene.symmetry);
  const bool isCut = scene.symmetry.cuts(*body.outline);
  const double share = isCut ? 0.5 : 1;  // of what acts on the whole body
  const auto course = [&](const std::string& key,
                          double factor) -> RigidBody::Component::Course {
    if (!motion.isParameter(key))
      return {};
    return [text = motion.get<std::string>(key),
            place = Place{scene.file, bem::message(path, "->Motion->", key)},
            names = scene.names(),
            factor](double t) { return factor * evaluateAt(t, text, place, names); };
  };
  constexpr std::array<const char*, 3> keys[] = {
      {"Displacement X", "Force X", "Stiffness X"},
      {"Displacement Y", "Force Y", "Stiffness Y"},
      {"Rotation", "Moment", "Stiffness Rotation"}};
  for (std::size_t c = 0; c < 3; ++c) {
    const auto& [moved, pushed, sprung] = keys[c];
    const bool isAlong = c < 2 && static_cast<int>(c) != scene.symmetry.axis;
    for (const char* key : keys[c])
      if (isCut && !isAlong && motion.isParameter(key))
        throw InputError(
            path, "->Motion->", key, ": the body lies on the line of symmetry, ",
            scene.symmetry.line(),
            " (Geometry->Symmetry); it has no motion across it and no rotation; "
            "remove it");
    const bool pushes = motion.isParameter(pushed);
    if (motion.isParameter(sprung))
      body.components[c] = {true, course(pushed, share),
                            share * motion.get<double>(sprung), course(moved, 1)};
    else if (pushes && motion.isParameter(moved))
      throw InputError(path, "->Motion->", pushed, ": ", moved,
                       " is given, too; a motion is prescribed, or free under a force, "
                       "not both, but where ",
                       sprung, " joins them");
    else
      body.components[c] = {pushes, pushes ? course(pushed, share) : course(moved, 1)};
  }
  const BodyLoadsReader loads(*scene.used, name, {scene.file, ""});
  if (loads.actsOnRigid()) {
    body.inside = [loads, used = scene.used, outline = body.outline, pole = body.pole,
                   names = scene.names()](double t) {
      Names now = names;
      now.t = t;
      return loads.resultant(*outline, pole, now);
    };
    body.inside(1);  // what contradicts itself shall be said at once
  }
  return body;
}

bool isRigid(const ParameterList& body) {
  return body.sublist("Material").get<bool>("Rigid");
}

}  // namespace

void readBodies(ParameterList& list, const ParameterList& discretization, Scene& scene) {
  std::vector<bem::Loops> loops;
  double length = 0;
  for (const auto& item : list) {
    if (item.first.find(':') != std::string::npos)
      throw InputError("Bodies: a body is named '", item.first,
                       "'; a name has no ':', which parts body:boundary");
    const std::string path = "Bodies->" + item.first + "->Geometry";
    loops.push_back(
        readLoops(list.sublist(item.first).sublist("Geometry"), scene.file, path));
    if (!isRigid(list.sublist(item.first)))
      length = std::max(length, bem::scalingOf(loops.back().outer).length);
  }
  loops = alignedWith(scene.symmetry, std::move(loops), *scene.used);
  std::size_t b = 0;
  for (const auto& item : list) {
    ParameterList& body = list.sublist(item.first);
    const bem::Loops& own = loops[b++];
    if (isRigid(body))
      scene.rigid.push_back(readRigid(body, item.first, scene, own));
    else
      scene.bodies.push_back(
          readBody(body, item.first, scene, own, length, discretization));
  }
  if (scene.bodies.empty())
    throw InputError("Bodies: all bodies are rigid; at least one must be elastic");
  scene.stress = std::numeric_limits<double>::infinity();
  for (const Body& body : scene.bodies)
    scene.stress = std::min(scene.stress, body.material.youngsModulus);
}

}  // namespace epafi::drivers
