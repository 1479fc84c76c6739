#include "drivers/scene/SceneReader.hpp"

#include "bem/base/Error.hpp"
#include "bem/base/Parameters.hpp"
#include "contact/multiplier/MultiplierBasis.hpp"
#include "contact/solve/LoadContinuation.hpp"
#include "drivers/process/Versions.hpp"
#include "drivers/scene/ConditionsReader.hpp"
#include "drivers/scene/GeometryFile.hpp"
#include "drivers/scene/SceneFile.hpp"
#include "drivers/scene/Schema.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_TwoDArray.hpp>

#include <algorithm>
#include <cmath>
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

void checkOneBody(const ParameterList& list) {
  if (!list.isSublist("Bodies"))
    return;  // the schema says what is wrong
  std::vector<std::string> names;
  for (const auto& item : list.sublist("Bodies"))
    names.push_back(item.first);
  if (names.size() != 1)
    throw InputError(names.empty()
                         ? "Bodies: no body is given; exactly one is needed"
                         : message("Bodies: exactly one body is possible for now, ",
                                   names.size(), " are given: ", bem::quotedList(names)));
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
                            std::size_t edges) {
  const std::string path = "Discretization->" + key;
  if (!list.isParameter(key))
    throw InputError(message(path, ": missing; give ", edges,
                             " numbers, one per edge, or Discretization->Mesh Size"));
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

std::vector<int> countsFromSize(const bem::Outline& outline, double size) {
  std::vector<int> counts;
  for (const bem::Edge& edge : outline.edges()) {
    // A length that is a multiple of the size up to rounding gives that multiple.
    const double count =
        std::ceil(edge.curve.length() * outline.scaling().length / size * (1 - 1e-12));
    if (count > largestMesh)
      throw InputError(message("Discretization->Mesh Size = ", size, ": gives ", count,
                               " elements on edge '", edge.boundary, "'; at most ",
                               largestMesh, " are possible"));
    counts.push_back(std::max(1, static_cast<int>(count)));
  }
  return counts;
}

std::vector<int> readElements(const ParameterList& list, const bem::Outline& outline,
                              int holes) {
  if (list.isParameter("Mesh Size")) {
    for (const auto& item : list)
      if (item.first.find("Elements per Edge") != std::string::npos)
        throw InputError(message("Discretization->", item.first,
                                 ": give this or Mesh Size, not both"));
    return countsFromSize(outline, list.get<double>("Mesh Size"));
  }
  const auto edgesOf = [&outline](int loop) {
    return static_cast<std::size_t>(
        std::count_if(outline.edges().begin(), outline.edges().end(),
                      [loop](const bem::Edge& edge) { return edge.loop == loop; }));
  };
  std::vector<int> counts = readCounts(list, "Elements per Edge", edgesOf(0));
  for (int hole = 1; hole <= holes; ++hole) {
    const auto inner =
        alongHole(readCounts(list, holeKey(hole, "Elements per Edge"), edgesOf(hole)));
    counts.insert(counts.end(), inner.begin(), inner.end());
  }
  for (const auto& item : list)
    if (item.first.rfind("Hole ", 0) == 0 && std::stol(item.first.substr(5)) > holes)
      throw InputError(
          message("Discretization->", item.first, ": the body has ", holes, " holes"));
  if (std::accumulate(counts.begin(), counts.end(), 0.0) > largestMesh)
    throw InputError(message("Discretization->Elements per Edge: more than ", largestMesh,
                             " elements"));
  return counts;
}

bem::Material readMaterial(const ParameterList& list) {
  bem::Material material;
  material.youngsModulus = list.get<double>("Young's Modulus");
  material.poissonsRatio = list.get<double>("Poisson's Ratio");
  material.planeStress = list.get<std::string>("Plane State") == "Plane Stress";
  return material;
}

/// V has the normals of each closed line in its kernel at ν = 1/2; only what Form Density
/// adds on contact elements takes them out.
void checkIncompressible(const Scene& scene, const std::string& path) {
  if (scene.material.poissonsRatio < 0.5 || scene.material.planeStress)
    return;
  if (scene.stabilization.form != contact::Stabilization::Form::Density)
    throw InputError(path +
                     ": is 1/2, which Discretization->Stabilization->Form = "
                     "Density allows in plane strain; other forms want less");
  const std::vector<bem::Edge>& edges = scene.outline->edges();
  std::vector<bool> seen(edges.size(), false);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    bool held = seen[k];
    for (std::size_t i = k; !seen[i]; i = static_cast<std::size_t>(edges[i].next)) {
      seen[i] = true;
      held = held || scene.conditions.contact.count(edges[i].boundary) != 0;
    }
    if (!held)
      throw InputError(path +
                       ": is 1/2, which needs a contact boundary on every closed "
                       "line of the outline; the one with '" +
                       edges[k].boundary + "' has none");
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

Scene::Output readOutput(const ParameterList& list, const bem::Outline& outline) {
  Scene::Output output;
  output.contactSamples = list.get<int>("Contact Samples per Element");
  output.fields = list.get<bool>("Fields");
  if (list.isParameter("Interior Points"))
    output.interiorPoints = pointsOf(list, "Interior Points");
  for (std::size_t i = 0; i < output.interiorPoints.size(); ++i)
    if (!outline.contains(output.interiorPoints[i]))
      throw InputError(message("Output->Interior Points: point ", i, " = (",
                               output.interiorPoints[i].x, ", ",
                               output.interiorPoints[i].y, ") is not inside the body"));
  return output;
}

Scene build(const std::string& file, const RawScene& raw) {
  checkOneBody(raw.list);
  Scene scene;
  scene.title = raw.title;
  scene.file = file;
  scene.used = Teuchos::rcp(new ParameterList(complete(raw.list, raw.title)));
  ParameterList& used = *scene.used;

  scene.body = used.sublist("Bodies").begin()->first;
  const std::string path = "Bodies->" + scene.body;
  ParameterList& body = used.sublist("Bodies").sublist(scene.body);
  scene.material = readMaterial(body.sublist("Material"));

  expandGeometryFile(body.sublist("Geometry"), file, path + "->Geometry");
  const ParameterList& geometry = body.sublist("Geometry");
  const int holes = countHoles(geometry, path + "->Geometry");
  const bem::Loop outer = readLoop(geometry, "", path + "->Geometry");
  std::vector<bem::Loop> inner;
  for (int hole = 1; hole <= holes; ++hole)
    inner.push_back(readLoop(geometry, holeKey(hole, ""), path + "->Geometry"));
  scene.outline = at(path + "->Geometry",
                     [&] { return std::make_shared<const bem::Outline>(outer, inner); });
  scene.conditions = readConditions(body, {file, path}, *scene.outline);

  const ParameterList& discretization = used.sublist("Discretization");
  scene.elementsPerEdge = readElements(discretization, *scene.outline, holes);
  scene.degree = discretization.get<int>("Degree");
  scene.multiplier = discretization.get<std::string>("Multiplier");
  scene.stabilization =
      contact::parseStabilization(discretization.sublist("Stabilization"));
  if (contact::multiplierBasis(scene.multiplier).sharesNodes)
    scene.stabilization.form = contact::Stabilization::Form::None;
  checkIncompressible(scene, path + "->Material->Poisson's Ratio");
  scene.solver = readSolver(used.sublist("Solver"));
  scene.linear = parseLinear(used.sublist("Solver").sublist("Linear"));
  scene.adaptivity = readAdaptivity(used.sublist("Adaptivity"));
  scene.output = readOutput(used.sublist("Output"), *scene.outline);
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
