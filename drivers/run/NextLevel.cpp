#include "drivers/run/NextLevel.hpp"

#include "adaptivity/mark/Analyticity.hpp"
#include "adaptivity/mark/Doerfler.hpp"
#include "adaptivity/mark/Strategy.hpp"
#include "adaptivity/refine/Refine.hpp"
#include "adaptivity/singular/Transitions.hpp"
#include "bem/base/Error.hpp"
#include "contact/multiplier/MultiplierSpace.hpp"
#include "drivers/run/BodySpaces.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace epafi::drivers {

LevelStart firstLevel(const Scene& scene) {
  LevelStart first;
  for (const Body& body : scene.bodies)
    first.meshes.push_back(firstMesh(body));
  return first;
}

namespace {

adaptivity::GradingOptions gradingOf(const Scene& scene) {
  adaptivity::GradingOptions grading = scene.adaptivity.strategy.grading;
  grading.largestDegree = contact::multiplierBasis(scene.multiplier).largestDegree;
  return grading;
}

/// The place on the edges that a contact meets which lies opposite to a place on the side.
std::optional<adaptivity::Transition> oppositeTo(const Scene& scene,
                                                 const ContactPair& pair,
                                                 const Scene::MetEdges& met,
                                                 const bem::Curve& curve, double t) {
  std::optional<adaptivity::Transition> found;
  double smallest = scene.reach(pair);
  for (std::size_t k = 0; k < met.curves.size(); ++k) {
    const auto there = contact::crossing(curve.point(t) + scene.shift(pair),
                                         curve.normal(t), met.curves[k]);
    if (!there || !contact::isOn(*there) || std::abs(there->distance) > smallest)
      continue;
    smallest = std::abs(there->distance);
    found = adaptivity::Transition{met.edges[k], met.curves[k].half() * (1 + there->t)};
  }
  return found;
}

/// Strong where contact between two bodies that deform ends, even at a corner: the pressure is
/// unbounded there, or jumps.
void markEnds(const ContactPair& pair, const contact::Conditions& conditions,
              adaptivity::PreparedMesh& side) {
  const auto touches = [&](int e) {
    const auto* contact = contact::contactOn(side.mesh, e, conditions);
    return contact != nullptr && contact->name == pair.name;
  };
  for (const int e : side.mesh.elementsOf(pair.side.boundary)) {
    const bem::Element& element = side.mesh[e];
    for (const auto& [neighbour, node] : {std::pair(element.previous, element.startNode),
                                          std::pair(element.next, element.endNode)})
      if (touches(e) && !touches(neighbour))
        side.singular.nodes[static_cast<std::size_t>(node)] =
            adaptivity::Singularity::Strong;
  }
}

/// Where contact or friction changes its state on one side it does so on the other, and where
/// either ends: singular points of both.
void shareSingularPoints(const Scene& scene,
                         std::vector<adaptivity::PreparedMesh>& prepared) {
  std::vector<std::vector<adaptivity::Transition>> found(prepared.size());
  for (std::size_t b = 0; b < prepared.size(); ++b)
    for (const RequiredNode& node : scene.bodies[b].nodes)
      found[b].push_back({node.edge, node.place});
  for (const ContactPair& pair : scene.contacts) {
    if (pair.met.rigid)
      continue;
    markEnds(pair, scene.bodies[pair.side.body].conditions, prepared[pair.side.body]);
    const bem::Mesh& mesh = prepared[pair.side.body].mesh;
    const adaptivity::SingularPoints& singular = prepared[pair.side.body].singular;
    const Scene::MetEdges met = scene.metEdges(pair);
    for (const int e : mesh.elementsOf(pair.side.boundary)) {
      bem::Vector places = singular.inside[static_cast<std::size_t>(e)];
      if (singular.at(mesh, e, false) == adaptivity::Singularity::Strong)
        places.push_back(-1);
      for (const double t : places)
        if (const auto there = oppositeTo(scene, pair, met, mesh[e].curve, t))
          found[pair.met.body].push_back(*there);
    }
  }
  for (std::size_t b = 0; b < prepared.size(); ++b)
    if (!found[b].empty())
      prepared[b].singular =
          adaptivity::placeOn(prepared[b].mesh, {found[b], prepared[b].singular});
}

std::vector<adaptivity::PreparedMesh> prepareAll(const Scene& scene,
                                                 const BodySpaces& spaces,
                                                 const Level& level,
                                                 const adaptivity::Strategy& strategy,
                                                 const bem::DenseAlgebra& algebra) {
  std::vector<bem::Vector> displacements;
  for (const BodyLevel& body : level.bodies)
    displacements.push_back(body.displacement);
  const contact::Motions motions = spaces.motions(displacements, level.rigid);
  const std::vector<bem::Mesh> coarse = firstLevel(scene).meshes;
  std::vector<adaptivity::PreparedMesh> prepared;
  for (std::size_t b = 0; b < spaces.size(); ++b)
    prepared.push_back(adaptivity::prepare(
        strategy,
        {spaces.space(b), scene.bodies[b].conditions, spaces.multiplier(b),
         level.bodies[b].states, level.bodies[b].displacement, coarse[b],
         *spaces.opposite(b), &motions},
        gradingOf(scene), algebra));
  shareSingularPoints(scene, prepared);
  return prepared;
}

/// The elements that carry most of the estimate are chosen among those of all bodies.
std::vector<adaptivity::Marks> marksOf(
    const Scene& scene, const BodySpaces& spaces, const Level& level,
    const adaptivity::Strategy& strategy,
    const std::vector<adaptivity::PreparedMesh>& prepared,
    const bem::DenseAlgebra& algebra) {
  std::vector<bem::Vector> squares;
  for (const BodyLevel& body : level.bodies)
    squares.push_back(body.indicators.elements());
  const auto worst =
      adaptivity::doerfler(squares, scene.adaptivity.strategy.markingFraction);
  std::vector<adaptivity::Marks> marks;
  for (std::size_t b = 0; b < spaces.size(); ++b) {
    const adaptivity::LevelData data{
        prepared[b].mesh, worst[b],
        adaptivity::looksAnalytic(spaces.space(b), scene.bodies[b].conditions,
                                  level.bodies[b].displacement, level.bodies[b].density,
                                  scene.adaptivity.strategy.analyticityThreshold),
        prepared[b].singular, gradingOf(scene)};
    marks.push_back(adaptivity::decide(strategy, data, algebra));
  }
  return marks;
}

}  // namespace

std::variant<LevelStart, Outcome> nextLevel(const Scene& scene, const Level& level,
                                            const bem::DenseAlgebra& algebra) {
  const auto converged = [](const char* reason) {
    return Outcome{contact::Status::Converged, reason};
  };
  if (level.status != contact::Status::Converged)
    return Outcome{level.status, bem::message("level ", level.number,
                                              " is not converged: ", level.reason)};
  if (level.estimate() < scene.adaptivity.limits.estimate)
    return converged("the estimate is below the target");
  if (level.number + 1 >= scene.adaptivity.limits.levels)
    return converged("all levels that the scene allows are computed");

  const BodySpaces spaces(scene, meshesOf(scene, level));
  const adaptivity::Strategy& strategy =
      adaptivity::strategy(scene.adaptivity.strategy.name);
  const std::vector<adaptivity::PreparedMesh> prepared =
      prepareAll(scene, spaces, level, strategy, algebra);
  const std::vector<adaptivity::Marks> marks =
      marksOf(scene, spaces, level, strategy, prepared, algebra);
  if (std::none_of(marks.begin(), marks.end(), adaptivity::anyMarked))
    return converged("there is nothing to refine");

  LevelStart next{level.number + 1, {}, {}};
  const bool carries = strategy.start == adaptivity::Start::Carried && !scene.history;
  if (carries)
    next.rigid = level.rigid;
  for (std::size_t b = 0; b < spaces.size(); ++b) {
    next.meshes.push_back(adaptivity::refine(prepared[b].mesh, marks[b]));
    if (carries)
      next.start.push_back(adaptivity::carry(spaces.space(b).mesh(), spaces.multiplier(b),
                                             level.bodies[b].state, next.meshes.back(),
                                             scene.bodies[b].conditions));
  }
  return next;
}

std::variant<LevelStart, Outcome> levelAfterRestart(const Scene& scene,
                                                    const Level& level,
                                                    const bem::DenseAlgebra& algebra) {
  if (level.status != contact::Status::Converged || !level.complete) {
    LevelStart again{level.number, meshesOf(scene, level), {}, level.path, level.rigid};
    for (const BodyLevel& body : level.bodies)
      again.start.push_back(body.state);
    return again;
  }
  return nextLevel(scene, level, algebra);
}

}  // namespace epafi::drivers
