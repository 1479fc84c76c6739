#include "drivers/scene/SceneReader.hpp"

#include "bem/base/Error.hpp"
#include "bem/base/Parameters.hpp"
#include "contact/multiplier/MultiplierBasis.hpp"
#include "contact/solve/LoadContinuation.hpp"
#include "drivers/process/Versions.hpp"
#include "drivers/scene/ConditionsReader.hpp"
#include "drivers/scene/ContactsReader.hpp"
#include "drivers/scene/GeometryFile.hpp"
#include "drivers/scene/SceneFile.hpp"
#include "drivers/scene/Schema.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_TwoDArray.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace epafi::drivers {

namespace {

using bem::InputError;
using bem::message;
using Teuchos::ParameterList;

/// Beyond this a mesh is a slip of the pen: its dense matrices would not fit anywhere.
constexpr double largestMesh = 1e6;

/// Adds where it happened to what a value's constructor complains about.
template <class Make>
auto at(const std::string& path, Make make) {
  try {
    return make();
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
}

std::vector<bem::Vec2> pointsOf(const ParameterList& list, const std::string& key) {
  const auto& table = list.get<Teuchos::TwoDArray<double>>(key);
  std::vector<bem::Vec2> points;
  points.reserve(static_cast<std::size_t>(table.getNumRows()));
  for (int i = 0; i < table.getNumRows(); ++i)
    points.push_back({table(i, 0), table(i, 1)});
  return points;
}

std::vector<std::string> namesOf(const ParameterList& list, const std::string& key) {
  return list.get<Teuchos::Array<std::string>>(key).toVector();
}

void checkAnyBody(const ParameterList& list) {
  if (list.isSublist("Bodies") &&
      list.sublist("Bodies").begin() == list.sublist("Bodies").end())
    throw InputError("Bodies: no body is given; at least one is needed");
}

std::string holeKey(int hole, const std::string& what) {
  return message("Hole ", hole, " ", what);
}

/// Holes 1, 2, ... without a gap in the numbering, each with vertices and edges.
int countHoles(const ParameterList& geometry, const std::string& path) {
  int holes = 0;
  while (geometry.isParameter(holeKey(holes + 1, "Vertices")) ||
         geometry.isParameter(holeKey(holes + 1, "Edges"))) {
    ++holes;
    for (const char* what : {"Vertices", "Edges"})
      if (!geometry.isParameter(holeKey(holes, what)))
        throw InputError(message(path, "->", holeKey(holes, what), ": missing"));
  }
  for (const auto& item : geometry)
    if (item.first.rfind("Hole ", 0) == 0 && std::stol(item.first.substr(5)) > holes)
      throw InputError(message(path, "->", item.first,
                               ": holes are numbered 1, 2, ...; hole ", holes + 1,
                               " is missing"));
  return holes;
}

bem::Loop readLoop(const ParameterList& geometry, const std::string& prefix,
                   const std::string& path) {
  bem::Loop loop{pointsOf(geometry, prefix + "Vertices"),
                 namesOf(geometry, prefix + "Edges")};
  if (geometry.isParameter(prefix + "Bulges"))
    loop.bulges = geometry.get<Teuchos::Array<double>>(prefix + "Bulges").toVector();
  const std::string key = path + "->" + prefix + "Edges";
  if (loop.edges.size() != loop.vertices.size())
    throw InputError(message(key, ": ", loop.vertices.size(), " vertices make ",
                             loop.vertices.size(), " edges, but ", loop.edges.size(),
                             " names are given; the polygon closes by itself"));
  if (!loop.bulges.empty() && loop.bulges.size() != loop.vertices.size())
    throw InputError(message(path, "->", prefix, "Bulges: ", loop.vertices.size(),
                             " edges have one bulge each (0: straight), but ",
                             loop.bulges.size(), " are given"));
  for (std::size_t i = 0; i < loop.edges.size(); ++i)
    if (loop.edges[i].empty() || loop.edges[i].find_first_of(",{}>") != std::string::npos)
      throw InputError(message(key, ": edge ", i, " is named '", loop.edges[i],
                               "'; a name is not empty and has none of , { } >"));
  return loop;
}

/// One number per edge, in the order of the user's loop.
std::vector<int> readCounts(const ParameterList& list, const std::string& key,
                            std::size_t edges, const std::string& parent) {
  const std::string path = parent + "->" + key;
  if (!list.isParameter(key))
    throw InputError(message(path, ": missing; give ", edges,
                             " numbers, one per edge, or ", parent, "->Mesh Size"));
  const auto& counts = list.get<Teuchos::Array<int>>(key);
  if (static_cast<std::size_t>(counts.size()) != edges)
    throw InputError(message(path, ": has ", counts.size(),
                             " numbers, but the polygon has ", edges, " edges"));
  return counts.toVector();
}

/// From the user's order on a hole to the outline's, see Outline: last but one, ..., 0,
/// last.
std::vector<int> alongHole(const std::vector<int>& counts) {
  std::vector<int> result(counts.rbegin() + 1, counts.rend());
  result.push_back(counts.back());
  return result;
}

std::vector<int> countsFromSize(const bem::Outline& outline, double size,
                                const std::string& parent) {
  std::vector<int> counts;
  for (const bem::Edge& edge : outline.edges()) {
    // A length that is a multiple of the size up to rounding gives that multiple.
    const double count =
        std::ceil(edge.curve.length() * outline.scaling().length / size * (1 - 1e-12));
    if (count > largestMesh)
      throw InputError(message(parent, "->Mesh Size = ", size, ": gives ", count,
                               " elements on edge '", edge.boundary, "'; at most ",
                               largestMesh, " are possible"));
    // an element turns by a quarter of a circle at most
    const double turns =
        std::ceil(std::abs(edge.curve.angle()) / 1.5707963267948966 - 1e-9);
    counts.push_back(std::max({1, static_cast<int>(count), static_cast<int>(turns)}));
  }
  return counts;
}

std::vector<int> readElements(const ParameterList& list, const bem::Outline& outline,
                              const std::string& parent) {
  const int holes = outline.loops() - 1;
  if (list.isParameter("Mesh Size")) {
    for (const auto& item : list)
      if (item.first.find("Elements per Edge") != std::string::npos)
        throw InputError(
            message(parent, "->", item.first, ": give this or Mesh Size, not both"));
    return countsFromSize(outline, list.get<double>("Mesh Size"), parent);
  }
  const auto edgesOf = [&outline](int loop) {
    return static_cast<std::size_t>(
        std::count_if(outline.edges().begin(), outline.edges().end(),
                      [loop](const bem::Edge& edge) { return edge.loop == loop; }));
  };
  std::vector<int> counts = readCounts(list, "Elements per Edge", edgesOf(0), parent);
  for (int hole = 1; hole <= holes; ++hole) {
    const auto inner = alongHole(
        readCounts(list, holeKey(hole, "Elements per Edge"), edgesOf(hole), parent));
    counts.insert(counts.end(), inner.begin(), inner.end());
  }
  for (const auto& item : list)
    if (item.first.rfind("Hole ", 0) == 0 && std::stol(item.first.substr(5)) > holes)
      throw InputError(
          message(parent, "->", item.first, ": the body has ", holes, " holes"));
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const bem::Curve& curve = outline.edge(static_cast<int>(k)).curve;
    constexpr double halfACircle = 3.1415926535897932 * (1 + 1e-12);
    if (std::abs(curve.angle()) > halfACircle * counts[k])
      throw InputError(
          message(parent, "->Elements per Edge: ", counts[k], " on an edge of '",
                  outline.edge(static_cast<int>(k)).boundary, "' that turns by ",
                  std::abs(curve.angle()) * 180 / 3.1415926535897932,
                  " degrees; an element turns by 180 at most"));
  }
  if (std::accumulate(counts.begin(), counts.end(), 0.0) > largestMesh)
    throw InputError(
        message(parent, "->Elements per Edge: more than ", largestMesh, " elements"));
  return counts;
}

bem::Material readMaterial(const ParameterList& list, const std::string& path) {
  for (const char* key : {"Young's Modulus", "Poisson's Ratio"})
    if (!list.isParameter(key))
      throw InputError(message(path, "->", key,
                               ": missing; every body that is not Rigid has "
                               "one"));
  bem::Material material;
  material.youngsModulus = list.get<double>("Young's Modulus");
  material.poissonsRatio = list.get<double>("Poisson's Ratio");
  material.planeStress = list.get<std::string>("Plane State") == "Plane Stress";
  return material;
}

/// Is there neither a condition on a boundary of a body, nor a load, nor another body?
bool isFree(const Scene& scene, std::size_t b, const std::string& boundary) {
  const contact::Conditions& conditions = scene.bodies[b].conditions;
  const auto neumann = conditions.neumann.find(boundary);
  const bool met = std::any_of(
      scene.contacts.begin(), scene.contacts.end(), [&](const ContactPair& pair) {
        return !pair.met.rigid && pair.met.body == b && pair.met.boundary == boundary;
      });
  return !met && conditions.dirichlet.count(boundary) == 0 &&
         (neumann == conditions.neumann.end() ||
          (!neumann->second.x && !neumann->second.y));
}

/// V has the normals of each closed line in its kernel at ν = 1/2. What Form Density adds on
/// contact elements takes them out, on other lines a pin on an edge without load, the longest.
void pinIncompressible(const contact::Stabilization& stabilization, std::size_t b,
                       Scene& scene) {
  Body& body = scene.bodies[b];
  if (body.material.poissonsRatio < 0.5 || body.material.planeStress)
    return;
  const std::string path = "Bodies->" + body.name + "->Material->Poisson's Ratio";
  if (stabilization.form != contact::Stabilization::Form::Density)
    throw InputError(path +
                     ": is 1/2, which Discretization->Stabilization->Form = "
                     "Density allows in plane strain; other forms want less");
  const contact::Conditions& conditions = body.conditions;
  const bool fixes = conditions.fix.x || conditions.fix.y || conditions.fix.rotation;
  const std::vector<bem::Edge>& edges = body.outline->edges();
  std::vector<bool> seen(edges.size(), false);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    bool held = seen[k];
    double longest = 0;
    int pin = -1;
    for (std::size_t i = k; !seen[i]; i = static_cast<std::size_t>(edges[i].next)) {
      seen[i] = true;
      held = held || conditions.contact.count(edges[i].boundary) != 0;
      if (edges[i].curve.length() > longest && isFree(scene, b, edges[i].boundary)) {
        longest = edges[i].curve.length();
        pin = static_cast<int>(i);
      }
    }
    if (!held && (pin < 0 || fixes))
      throw InputError(
          path +
          ": is 1/2, which needs on every closed line of the outline a "
          "boundary that carries contact stresses or, without Rigid Motions->"
          "Fix, one without any condition; the line with '" +
          edges[k].boundary + "' has none");
    if (!held)
      body.conditions.pins.push_back(pin);
  }
}

Scene::Solver readSolver(const ParameterList& list) {
  Scene::Solver solver{contact::parseTresca(list), contact::parseCoulomb(list),
                       contact::parseLoadSteps(list), nullptr};
  if (list.isSublist("NOX") && list.sublist("NOX").numParams() > 0) {
    const auto nox = std::make_shared<ParameterList>(list.sublist("NOX"));
    nox->setName("Solver->NOX");
    solver.nox = nox;
  }
  return solver;
}

Scene::Adaptivity readAdaptivity(const ParameterList& list) {
  Scene::Adaptivity adaptivity{adaptivity::parseStrategy(list),
                               adaptivity::parseEstimator(list), parseLimits(list)};
  if (adaptivity::strategy(adaptivity.strategy.name).levels == adaptivity::Levels::One)
    adaptivity.limits.levels = 1;
  return adaptivity;
}

Scene::Output readOutput(const ParameterList& list, const Scene& scene) {
  Scene::Output output;
  output.contactSamples = list.get<int>("Contact Samples per Element");
  output.fields = list.get<bool>("Fields");
  if (list.isParameter("Interior Points"))
    output.interiorPoints = pointsOf(list, "Interior Points");
  for (std::size_t i = 0; i < output.interiorPoints.size(); ++i)
    if (scene.bodyAt(output.interiorPoints[i]) == scene.bodies.size())
      throw InputError(message("Output->Interior Points: point ", i, " = (",
                               output.interiorPoints[i].x, ", ",
                               output.interiorPoints[i].y,
                               scene.bodies.size() == 1 ? ") is not inside the body"
                                                        : ") is not inside any body"));
  return output;
}

/// A body's polygons, as the user wrote them.
struct Loops {
  bem::Loop outer;
  std::vector<bem::Loop> holes;
};

Loops readLoops(ParameterList& geometry, const std::string& file,
                const std::string& path) {
  expandGeometryFile(geometry, file, path);
  const int holes = countHoles(geometry, path);
  Loops loops{readLoop(geometry, "", path), {}};
  for (int hole = 1; hole <= holes; ++hole)
    loops.holes.push_back(readLoop(geometry, holeKey(hole, ""), path));
  return loops;
}

/// Where bodies share a scaling it is for the largest.
std::shared_ptr<const bem::Outline> makeOutline(const Loops& loops, double length,
                                                const std::string& path) {
  return at(path, [&] {
    bem::Scaling scaling = bem::scalingOf(loops.outer);
    scaling.length = std::max(scaling.length, length);
    return std::make_shared<const bem::Outline>(loops.outer, loops.holes, scaling);
  });
}

/// A body's own mesh says more than the scene's Discretization.
void readMesh(const ParameterList& own, const ParameterList& discretization,
              const std::string& path, Body& body) {
  const bool sized = own.isParameter("Mesh Size") || own.isParameter("Elements per Edge");
  body.elementsPerEdge =
      sized ? readElements(own, *body.outline, path + "->Mesh")
            : readElements(discretization, *body.outline, "Discretization");
  body.degree = own.isParameter("Degree") ? own.get<int>("Degree")
                                          : discretization.get<int>("Degree");
}

void refuseMotion(const ParameterList& motion, const std::string& path) {
  for (const auto& item : motion)
    if (!item.second.isDefault())
      throw InputError(message(path, "->Motion->", item.first,
                               ": belongs to a body with Material->Rigid = true; others "
                               "have Boundary Conditions and Rigid Motions"));
}

Body readBody(ParameterList& list, const std::string& name, const Scene& scene,
              const Loops& loops, double length, const ParameterList& discretization) {
  const std::string path = "Bodies->" + name;
  Body body;
  body.name = name;
  body.material = readMaterial(list.sublist("Material"), path + "->Material");
  refuseMotion(list.sublist("Motion"), path);
  body.outline = makeOutline(loops, length, path + "->Geometry");
  body.conditions =
      readConditions(list, {scene.file, path}, *body.outline, {scene.constants});
  readMesh(list.sublist("Mesh"), discretization, path, body);
  return body;
}

void refuseElasticity(const ParameterList& list, const std::string& path) {
  const auto refuse = [&](const std::string& key) {
    throw InputError(message(path, "->", key,
                             ": the body is rigid (Material->Rigid = true); "
                             "it has Geometry and Motion alone"));
  };
  for (const char* key : {"Young's Modulus", "Poisson's Ratio"})
    if (list.sublist("Material").isParameter(key))
      refuse(std::string("Material->") + key);
  for (const char* part : {"Boundary Conditions", "Mesh", "Rigid Motions"})
    for (const auto& item : list.sublist(part))
      if (!item.second.isDefault())
        refuse(std::string(part) + "->" + item.first);
}

bem::Vec2 centroidOf(const bem::Outline& outline) {
  bem::Vec2 sum;
  double length = 0;
  for (const bem::Edge& edge : outline.edges()) {
    sum = sum + edge.curve.length() * edge.curve.centroid();
    length += edge.curve.length();
  }
  return outline.physical((1 / length) * sum);
}

bem::Vec2 readPole(const ParameterList& motion, const std::string& path,
                   const bem::Outline& outline) {
  if (!motion.isParameter("Reference Point"))
    return centroidOf(outline);
  const auto& point = motion.get<Teuchos::Array<double>>("Reference Point");
  if (point.size() != 2)
    throw InputError(message(path, ": has ", point.size(), " numbers; a point has two"));
  return {point[0], point[1]};
}

RigidBody readRigid(const ParameterList& list, const std::string& name,
                    const Scene& scene, const Loops& loops) {
  const std::string path = "Bodies->" + name;
  refuseElasticity(list, path);
  RigidBody body;
  body.name = name;
  body.outline = makeOutline(loops, 0, path + "->Geometry");
  const ParameterList& motion = list.sublist("Motion");
  body.pole = readPole(motion, path + "->Motion->Reference Point", *body.outline);
  constexpr std::pair<const char*, const char*> keys[] = {{"Displacement X", "Force X"},
                                                          {"Displacement Y", "Force Y"},
                                                          {"Rotation", "Moment"}};
  for (std::size_t c = 0; c < 3; ++c) {
    const auto& [moved, pushed] = keys[c];
    const bool free = motion.isParameter(pushed);
    if (free && motion.isParameter(moved))
      throw InputError(message(path, "->Motion->", pushed, ": ", moved,
                               " is given, too; a motion is prescribed, or free under a "
                               "force, not both"));
    const std::string key = free ? pushed : moved;
    if (motion.isParameter(key))
      body.components[c] = {free, [text = motion.get<std::string>(key),
                                   place = Place{scene.file, path + "->Motion->" + key},
                                   constants = scene.constants](double t) {
                              return evaluateAt(t, text, place, constants);
                            }};
  }
  return body;
}

bool isRigid(const ParameterList& body) {
  return body.sublist("Material").get<bool>("Rigid");
}

/// Elastic bodies in one length, that of the largest, and one stress, that of the softest.
/// Rigid ones do not count: they must not change what the others do.
void readBodies(ParameterList& list, const ParameterList& discretization, Scene& scene) {
  std::vector<Loops> loops;
  double length = 0;
  for (const auto& item : list) {
    const std::string path = "Bodies->" + item.first + "->Geometry";
    loops.push_back(
        readLoops(list.sublist(item.first).sublist("Geometry"), scene.file, path));
    if (!isRigid(list.sublist(item.first)))
      length = std::max(length, bem::scalingOf(loops.back().outer).length);
  }
  std::size_t b = 0;
  for (const auto& item : list) {
    ParameterList& body = list.sublist(item.first);
    const Loops& own = loops[b++];
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

void readHistory(ParameterList& used, Scene& scene) {
  scene.history = parseHistory(used.sublist("History"));
  if (!scene.history) {
    used.remove("History");
    return;
  }
  scene.conditionsAt = [lists = scene.used, file = scene.file, bodies = scene.bodies,
                        constants = scene.constants](double t) {
    std::vector<contact::Conditions> all;
    for (const Body& body : bodies) {
      all.push_back(readConditions(lists->sublist("Bodies").sublist(body.name),
                                   {file, "Bodies->" + body.name}, *body.outline,
                                   {constants, t}));
      for (const auto& [boundary, contact] : body.conditions.contact)
        if (!contact.name.empty()) {
          contact::Conditions::Contact now =
              readContactOfBodies(lists->sublist("Contacts").sublist(contact.name),
                                  {file, "Contacts->" + contact.name},
                                  {constants, t, normalOn(*body.outline, boundary)});
          now.name = contact.name;
          now.parts = contact.parts;
          all.back().contact[boundary] = std::move(now);
        }
    }
    return all;
  };
  const std::vector<contact::Conditions> end = scene.conditionsAt(scene.endOfPath());
  for (std::size_t b = 0; b < end.size(); ++b)
    scene.bodies[b].conditions = end[b];
}

Scene build(const std::string& file, const RawScene& raw) {
  checkAnyBody(raw.list);
  Scene scene;
  scene.title = raw.title;
  scene.file = file;
  scene.used = Teuchos::rcp(new ParameterList(complete(raw.list, raw.title)));
  ParameterList& used = *scene.used;

  scene.constants = readConstants(used.sublist("Constants"), {file, "Constants"});
  const ParameterList& discretization = used.sublist("Discretization");
  readBodies(used.sublist("Bodies"), discretization, scene);
  readContacts(used.sublist("Contacts"), file, scene);
  scene.multiplier = discretization.get<std::string>("Multiplier");
  scene.stabilization =
      contact::parseStabilization(discretization.sublist("Stabilization"));
  if (contact::multiplierBasis(scene.multiplier).sharesNodes)
    scene.stabilization.form = contact::Stabilization::Form::None;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    pinIncompressible(scene.stabilization, b, scene);
  scene.solver = readSolver(used.sublist("Solver"));
  readHistory(used, scene);
  if (scene.history && scene.solver.loadSteps > 1)
    throw InputError(message(
        "Solver->Load Steps = ", scene.solver.loadSteps,
        ": a continuation without memory does not go together with History; History->"
        "Steps makes the steps of a path, and one that fails is halved"));
  scene.linear = parseLinear(used.sublist("Solver").sublist("Linear"));
  checkLinear(scene);
  scene.adaptivity = readAdaptivity(used.sublist("Adaptivity"));
  scene.output = readOutput(used.sublist("Output"), scene);
  return scene;
}

}  // namespace

namespace {

/// Every message names the file first.
template <class Read>
auto naming(const std::string& file, const Read& read) {
  try {
    return read();
  } catch (const InputError& error) {
    const std::string what = error.what();
    if (what.rfind(file + ": ", 0) == 0)
      throw;
    throw InputError(file + ": " + what);
  }
}

}  // namespace

Scene readScene(const std::string& file, const std::vector<std::string>& overrides) {
  return sceneOf(naming(file, [&] { return readText(file); }), file, overrides);
}

Scene sceneOf(const std::string& text, const std::string& file,
              const std::vector<std::string>& overrides) {
  return naming(file, [&] {
    RawScene raw = rawScene(text, file);
    for (const std::string& assignment : overrides)
      applyOverride(raw.list, assignment);
    return build(file, raw);
  });
}

std::string usedXml(const Scene& scene) {
  ParameterList list(*scene.used);
  const Versions current = versions();
  list.remove("Versions", false);
  list.sublist("Versions")
      .set("Epafi", current.epafi)
      .set("Trilinos", current.trilinos)
      .set("MPI", current.mpi)
      .set("BLAS Core", current.blasCore);
  return toXml(list, scene.title);
}

}  // namespace epafi::drivers
