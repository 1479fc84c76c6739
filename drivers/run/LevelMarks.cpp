#include "drivers/run/LevelMarks.hpp"

#include "adaptivity/mark/Analyticity.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/geometry/NormalRay.hpp"
#include "contact/multiplier/MultiplierSpace.hpp"
#include "drivers/run/ContactEstimate.hpp"
#include "drivers/run/MatchedSides.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace epafi::drivers {

namespace {

/// Does nothing touch where sides overlap, which is most of the error?  Their contact is shorter than the
/// elements, by an unknown factor: such a level tells of no error but this one, and is not to be
/// followed by another.
bool overlooksContact(const Level& level, const std::vector<SolvedState>& steps) {
  adaptivity::Contributions squares = level.squares();
  const double all = std::accumulate(squares.begin(), squares.end(), 0.0);
  return of(squares, adaptivity::Source::Penetration) > 0.5 * all &&
         std::none_of(steps.begin(), steps.end(), [](const SolvedState& step) {
           return bem::largestEntry(step.state.multiplier) > 0;
         });
}

adaptivity::GradingOptions gradingOf(const Scene& scene, bool isOverlooked) {
  constexpr int deep = 3;
  adaptivity::GradingOptions grading = scene.adaptivity.strategy.grading;
  grading.largestDegree = contact::multiplierBasis(scene.multiplier).largestDegree;
  if (isOverlooked)
    grading.layers = deep;
  return grading;
}

/// A body's mesh and its singular points.  Refers to the mesh.
struct SingularMesh {
  const bem::Mesh& mesh;
  adaptivity::SingularPoints singular;
};

// Refinement of opposite sides of contacts between elastic bodies.
//                                              [doc/theory/estimators.md, Several bodies]

using adaptivity::Singularity;

/// What a contact's sides see of each other.
struct Sides {
  Sides(const Scene& scene, const ContactPair& pair)
      : conditions(scene.bodies[pair.side.body].conditions),
        visibility(scene.visibility(pair)),
        shift(scene.shift(pair)) {}

  /// What lies opposite to a place on an element of the side.
  std::optional<bem::FacedPoint> opposite(const bem::Mesh& mesh, int e, double t,
                                          const bem::CurveTree& curves) const {
    return faced(mesh[e].curve.moved(shift), t, curves, visibility,
                 contact::sightOf(mesh, e, conditions));
  }

  const contact::Conditions& conditions;
  bem::Visibility visibility;
  bem::Vec2 shift;
};

/// Strong where contact between two bodies that deform ends, even at a corner: the pressure is
/// unbounded there, or jumps.
void markEnds(const ContactPair& pair, const contact::Conditions& conditions,
              SingularMesh& side) {
  const auto touches = [&](int e) {
    const auto* contact = contact::contactOn(side.mesh, e, conditions);
    return contact != nullptr && contact->name == pair.name;
  };
  for (const int e : side.mesh.elementsOf(pair.side.boundary)) {
    const bem::Element& element = side.mesh[e];
    for (const auto& [neighbour, node] : {std::pair(element.previous, element.startNode),
                                          std::pair(element.next, element.endNode)})
      if (touches(e) && !touches(neighbour))
        side.singular.nodes[node] = Singularity::Strong;
  }
}

/// Places of an element that lie beside strong singular points.
bem::Vector besideSingular(const SingularMesh& side, int e) {
  constexpr double close = 1e-6;
  bem::Vector places;
  if (side.singular.at(side.mesh, e, false) == Singularity::Strong)
    places.push_back(-1 + close);
  for (const double t : side.singular.inside[e]) {
    places.push_back(t - close);
    places.push_back(t + close);
  }
  if (side.singular.at(side.mesh, e, true) == Singularity::Strong)
    places.push_back(1 - close);
  return places;
}

bool has(const std::vector<int>& elements, int e) {
  return std::binary_search(elements.begin(), elements.end(), e);
}

/// What a side's singular points are opposite to on the body that it meets.
std::vector<adaptivity::EdgePlace> oppositePoints(const Scene& scene,
                                                  const ContactPair& pair,
                                                  const SingularMesh& side) {
  const bem::Mesh& mesh = side.mesh;
  const Scene::OppositeEdges opposite = scene.oppositeEdges(pair);
  const std::vector<bem::Curve>& curves = opposite.curves.curves();
  const Sides sides(scene, pair);
  std::vector<adaptivity::EdgePlace> found;
  for (const int e : mesh.elementsOf(pair.side.boundary)) {
    bem::Vector places = side.singular.inside[e];
    for (const bool end : {false, true})
      if (side.singular.at(mesh, e, end) == Singularity::Strong)
        places.push_back(end ? 1 : -1);
    for (const double t : places)
      if (const auto there = sides.opposite(mesh, e, t, opposite.curves))
        found.push_back({opposite.edges[there->curve],
                         curves[there->curve].half() * (1 + there->crossing.t)});
  }
  return found;
}

/// Elements of a side and of the one that it meets, beside a singular point of the side.
std::vector<std::pair<int, int>> facingPairs(const Scene& scene, const ContactPair& pair,
                                             const SingularMesh& side,
                                             const bem::Mesh& opposite) {
  const std::vector<int> numbers = opposite.elementsOf(pair.opposite.boundary);
  std::vector<bem::Curve> elements;
  std::transform(numbers.begin(), numbers.end(), std::back_inserter(elements),
                 [&](int e) { return opposite[e].curve; });
  const bem::CurveTree curves(std::move(elements));
  const Sides sides(scene, pair);
  std::vector<std::pair<int, int>> pairs;
  for (const int e : side.mesh.elementsOf(pair.side.boundary))
    for (const double t : besideSingular(side, e))
      if (const auto there = sides.opposite(side.mesh, e, t, curves))
        pairs.emplace_back(e, numbers[there->curve]);
  return pairs;
}

/// Adds to each side of a contact the singular points opposite: transitions, and the ends
/// of the other side.
void shareSingularPoints(const Scene& scene, std::vector<SingularMesh>& meshes) {
  std::vector<std::vector<adaptivity::EdgePlace>> found(meshes.size());
  for (std::size_t b = 0; b < meshes.size(); ++b)
    for (const auto* nodes : {&scene.bodies[b].nodes, &scene.bodies[b].peaks})
      for (const RequiredNode& node : *nodes)
        found[b].push_back({node.edge, node.place});
  for (const ContactPair& pair : scene.contacts) {
    if (pair.opposite.rigid)
      continue;
    markEnds(pair, scene.bodies[pair.side.body].conditions, meshes[pair.side.body]);
    const auto points = oppositePoints(scene, pair, meshes[pair.side.body]);
    found[pair.opposite.body].insert(found[pair.opposite.body].end(), points.begin(),
                                     points.end());
  }
  for (std::size_t b = 0; b < meshes.size(); ++b)
    if (!found[b].empty())
      meshes[b].singular =
          adaptivity::withStrong(std::move(meshes[b].singular), meshes[b].mesh, found[b]);
}

/// The marked elements of all bodies, and for those beside a strong singular point the
/// opposite elements, unless less than half as long, so that both sides are graded alike.
/// \param worst marked elements, by body
std::vector<std::vector<int>> withFacing(const Scene& scene,
                                         const std::vector<SingularMesh>& meshes,
                                         std::vector<std::vector<int>> worst) {
  constexpr double shortest = 0.5 + 1e-6;  // half as long is common, and no more
  const std::vector<std::vector<int>> chosen = worst;
  for (const ContactPair& pair : scene.contacts) {
    if (pair.opposite.rigid)
      continue;
    const std::size_t a = pair.side.body;
    const std::size_t b = pair.opposite.body;
    const bem::Mesh& side = meshes[a].mesh;
    const bem::Mesh& opposite = meshes[b].mesh;
    for (const auto& [e, facing] : facingPairs(scene, pair, meshes[a], opposite)) {
      if (has(chosen[a], e) && opposite[facing].half > shortest * side[e].half)
        worst[b].push_back(facing);
      if (has(chosen[b], facing) && side[e].half > shortest * opposite[facing].half)
        worst[a].push_back(e);
    }
  }
  for (std::vector<int>& elements : worst) {
    std::sort(elements.begin(), elements.end());
    elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
  }
  return worst;
}

std::vector<SingularMesh> singularMeshes(const BodySpaces& spaces,
                                         const std::vector<SolvedState>& steps,
                                         bool isOverlooked) {
  const Scene& scene = spaces.scene();
  std::vector<SingularMesh> meshes;
  std::vector<contact::ContactStates> states;
  states.reserve(steps.size());
  for (const SolvedState& step : steps)
    states.push_back(step.states);
  for (std::size_t b = 0; b < spaces.size(); ++b) {
    const bem::Mesh& mesh = spaces.space(b).mesh();
    meshes.push_back({mesh, adaptivity::singularPoints(strategyOf(scene),
                                                       gradingOf(scene, isOverlooked),
                                                       mesh, scene.bodies[b].conditions,
                                                       spaces.multiplier(), b, states)});
  }
  shareSingularPoints(scene, meshes);
  return meshes;
}

/// Of each element of a body: does it look analytic in every step?
std::vector<bool> analyticIn(const std::vector<SolvedState>& steps, std::size_t b,
                             const BodySpaces& spaces) {
  const Scene& scene = spaces.scene();
  const bem::Space& space = spaces.space(b);
  std::vector<bool> always(space.mesh().size(), true);
  for (const SolvedState& step : steps) {
    const std::vector<bool> now = adaptivity::looksAnalytic(
        space, scene.bodies[b].conditions, step.displacement[b], step.density[b],
        scene.adaptivity.strategy.analyticityThreshold);
    std::transform(now.begin(), now.end(), always.begin(), always.begin(),
                   std::logical_and<>());
  }
  return always;
}

/// The steps whose tractions are not rounding beside the largest ones.  In others, such as one in
/// which all loads are gone, the states of contact are rounding, too.
std::vector<SolvedState> loaded(std::vector<SolvedState> steps) {
  constexpr double rounding = 1e-9;
  const auto largestOf = [](const SolvedState& step) {
    double largest = 0;
    for (const bem::Vector& density : step.density)
      largest = std::max(largest, bem::largestEntry(density));
    return largest;
  };
  double largest = 0;
  for (const SolvedState& step : steps)
    largest = std::max(largest, largestOf(step));
  steps.erase(std::remove_if(steps.begin(), steps.end(),
                             [&](const SolvedState& step) {
                               return largestOf(step) < rounding * largest;
                             }),
              steps.end());
  return steps;
}

}  // namespace

const adaptivity::Strategy& strategyOf(const Scene& scene) {
  return adaptivity::strategies().at(scene.adaptivity.strategy.name);
}

std::vector<adaptivity::Marks> marksOf(const BodySpaces& spaces, const Level& level,
                                       bool ofContacts, const bem::Processes& processes) {
  const Scene& scene = spaces.scene();
  const std::vector<SolvedState> steps = loaded(level.steps);
  const bool isOverlooked = overlooksContact(level, steps);
  const std::vector<SingularMesh> meshes = singularMeshes(spaces, steps, isOverlooked);
  const adaptivity::Strategy& strategy = strategyOf(scene);
  std::vector<bem::Vector> squares;
  for (std::size_t b = 0; b < spaces.size(); ++b) {
    squares.push_back(level.indicators[b].elements());
    for (std::size_t e = 0; e < squares[b].size(); ++e)  // those are not worth a level
      if (adaptivity::isShort(meshes[b].mesh, static_cast<int>(e)))
        squares[b][e] = 0;
  }
  if (ofContacts)
    squares = onlyMissing(level.contacts, *scene.adaptivity.limits.tolerance,
                          std::move(squares));
  auto worst = adaptivity::doerfler(squares, scene.adaptivity.strategy.markingFraction);
  if (strategy.grading == adaptivity::Grading::Obeyed)
    worst = withFacing(scene, meshes, std::move(worst));
  std::vector<const bem::Mesh*> all;
  for (const SingularMesh& mesh : meshes)
    all.push_back(&mesh.mesh);
  shareMarked(scene, all, worst);
  std::vector<adaptivity::Marks> marks;
  for (std::size_t b = 0; b < spaces.size(); ++b) {
    const adaptivity::LevelData data{meshes[b].mesh, worst[b],
                                     analyticIn(steps, b, spaces), meshes[b].singular,
                                     gradingOf(scene, isOverlooked)};
    marks.push_back(adaptivity::decide(strategy, data, processes));
  }
  if (ofContacts) {
    const auto few = tooFew(level.contacts, spaces.size());
    for (std::size_t b = 0; b < spaces.size(); ++b)
      for (const int e : few[b])
        if (!adaptivity::isShort(meshes[b].mesh, e))
          marks[b][e] = adaptivity::Mark::Bisect;
  }
  shareMarks(scene, all, marks);
  return marks;
}

}  // namespace epafi::drivers
