#include "bem/base/Error.hpp"
#include "drivers/scene/BodyLoadsReader.hpp"
#include "drivers/scene/Readers.hpp"
#include "drivers/scene/Revolution.hpp"

#include <Teuchos_ParameterList.hpp>

#include <algorithm>
#include <array>
#include <limits>

namespace epafi::drivers {

namespace {

using bem::InputError;
using Teuchos::ParameterList;

bem::Material readMaterial(const Part& part) {
  for (const char* key : {"Young's Modulus", "Poisson's Ratio"})
    if (!part.has(key))
      throw InputError(part.path(key), ": missing; every body that is not Rigid has one");
  bem::Material material;
  material.youngsModulus = part.list->get<double>("Young's Modulus");
  material.poissonsRatio = part.list->get<double>("Poisson's Ratio");
  material.planeStress = part.list->get<std::string>("Plane State") == "Plane Stress";
  return material;
}

Body readBody(const Part& part, const std::string& name, const Scene& scene,
              const bem::Loops& loops, double length) {
  Body body;
  body.name = name;
  body.material = readMaterial(part.sub("Material"));
  const Part motion = part.sub("Motion");
  for (const auto& item : *motion.list)
    if (!item.second.isDefault())
      throw InputError(motion.path(item.first),
                       ": belongs to a body with Material->Rigid = true; others "
                       "have Boundary Conditions and Rigid Motions");
  body.outline = makeOutline(loops, length, scene, part.path("Geometry"));
  body.conditions = readConditions(part, *body.outline, scene.symmetry);
  readMesh(part.sub("Mesh"), scene.root().sub("Discretization"), body);
  return body;
}

void refuseElasticity(const Part& body) {
  const auto refuse = [](const std::string& path) {
    throw InputError(path,
                     ": the body is rigid (Material->Rigid = true); it has "
                     "Geometry, Motion and what acts on mass alone");
  };
  const Part material = body.sub("Material");
  for (const char* key : {"Young's Modulus", "Poisson's Ratio"})
    if (material.has(key))
      refuse(material.path(key));
  for (const char* name :
       {"Boundary Conditions", "Mesh", "Rigid Motions", "Thermal Conditions"})
    for (const auto& item : body.list->sublist(name))
      if (!item.second.isDefault())
        refuse(body.sub(name).path(item.first));
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
  if (outline.isAxisymmetric())
    centroid.x = 0;
  return centroid;
}

RigidBody readRigid(const Part& part, const std::string& name, const Scene& scene,
                    const bem::Loops& loops) {
  refuseElasticity(part);
  RigidBody body;
  body.name = name;
  body.outline = makeOutline(loops, 0, scene, part.path("Geometry"));
  const Part motion = part.sub("Motion");
  body.pole = motion.has("Reference Point") ? motion.point("Reference Point")
                                            : centroidOf(*body.outline, scene.symmetry);
  const bool isCut = scene.symmetry.cuts(*body.outline);
  const double share = isCut ? 0.5 : 1;  // of force and stiffness of the whole body
  const auto course = [&](const std::string& key,
                          double factor) -> RigidBody::Component::Course {
    if (!motion.has(key))
      return {};
    return [now = motion, key, factor](double t) { return factor * now.number(key, t); };
  };
  constexpr std::array<const char*, 3> keys[] = {
      {"Displacement X", "Force X", "Stiffness X"},
      {"Displacement Y", "Force Y", "Stiffness Y"},
      {"Rotation", "Moment", "Stiffness Rotation"}};
  for (std::size_t c = 0; c < 3; ++c) {
    const auto& [moved, pushed, sprung] = keys[c];
    const bool isAlong = c < 2 && static_cast<int>(c) != scene.symmetry.axis;
    for (const char* key : keys[c])
      if (isCut && !isAlong && motion.has(key))
        throw InputError(
            motion.path(key), ": the body lies on the line of symmetry, ",
            scene.symmetry.line(),
            " (Geometry->Symmetry); it has no motion across it and no rotation; "
            "remove it");
    const bool pushes = motion.has(pushed);
    if (motion.has(sprung))
      body.components[c] = {true, course(pushed, share),
                            share * motion.list->get<double>(sprung), course(moved, 1)};
    else if (pushes && motion.has(moved))
      throw InputError(motion.path(pushed), ": ", moved,
                       " is given, too; a motion is prescribed, or free under a force, "
                       "not both, but where ",
                       sprung, " joins them");
    else
      body.components[c] = {pushes, pushes ? course(pushed, share) : course(moved, 1)};
  }
  if (BodyLoadsReader(scene.root(), name).actsOnRigid()) {
    body.inside = [root = scene.root(), name, outline = body.outline,
                   pole = body.pole](double t) {
      return BodyLoadsReader(root.then(t), name).resultant(*outline, pole);
    };
    body.inside(1);  // evaluate once, so that errors are reported now
  }
  return body;
}

bool isRigid(const ParameterList& body) {
  return body.sublist("Material").get<bool>("Rigid");
}

}  // namespace

void readBodies(Scene& scene) {
  ParameterList& list = scene.used->sublist("Bodies");
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
  if (scene.isAxisymmetric)
    loops = alignedWithAxis(std::move(loops), *scene.used);
  loops = alignedWith(scene.symmetry, std::move(loops), *scene.used);
  std::size_t b = 0;
  for (const auto& item : list) {
    const Part body = scene.root().sub("Bodies").sub(item.first);
    const bem::Loops& own = loops[b++];
    if (isRigid(*body.list))
      scene.rigid.push_back(readRigid(body, item.first, scene, own));
    else
      scene.bodies.push_back(readBody(body, item.first, scene, own, length));
  }
  if (scene.bodies.empty())
    throw InputError("Bodies: all bodies are rigid; at least one must be elastic");
  scene.stress = std::numeric_limits<double>::infinity();
  for (const Body& body : scene.bodies)
    scene.stress = std::min(scene.stress, body.material.youngsModulus);
}

}  // namespace epafi::drivers
