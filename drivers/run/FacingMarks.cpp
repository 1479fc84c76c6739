#include "drivers/run/FacingMarks.hpp"

#include "bem/geometry/NormalRay.hpp"
#include "contact/multiplier/MultiplierSpace.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

namespace epafi::drivers {

namespace {

using adaptivity::Singularity;

/// A place on one of several curves.
struct Place {
  std::size_t curve = 0;
  double t = 0;
};

/// That opposite to a place on the side of a contact.
std::optional<Place> oppositeTo(const Scene& scene, const ContactPair& pair,
                                const bem::Curve& side, double t,
                                const std::vector<bem::Curve>& opposite) {
  std::optional<Place> found;
  double smallest = scene.reach(pair);
  for (std::size_t k = 0; k < opposite.size(); ++k) {
    const auto there =
        bem::crossing(side.point(t) + scene.shift(pair), side.normal(t), opposite[k]);
    if (!there || !bem::isOn(*there) || std::abs(there->distance) > smallest)
      continue;
    smallest = std::abs(there->distance);
    found = Place{k, there->t};
  }
  return found;
}

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
  std::vector<adaptivity::EdgePlace> found;
  for (const int e : mesh.elementsOf(pair.side.boundary)) {
    bem::Vector places = side.singular.inside[e];
    for (const bool end : {false, true})
      if (side.singular.at(mesh, e, end) == Singularity::Strong)
        places.push_back(end ? 1 : -1);
    for (const double t : places)
      if (const auto there = oppositeTo(scene, pair, mesh[e].curve, t, opposite.curves))
        found.push_back({opposite.edges[there->curve],
                         opposite.curves[there->curve].half() * (1 + there->t)});
  }
  return found;
}

/// Elements of a side and of the one that it meets, beside a singular point of the side.
std::vector<std::pair<int, int>> facingPairs(const Scene& scene, const ContactPair& pair,
                                             const SingularMesh& side,
                                             const bem::Mesh& opposite) {
  const std::vector<int> numbers = opposite.elementsOf(pair.opposite.boundary);
  std::vector<bem::Curve> curves;
  std::transform(numbers.begin(), numbers.end(), std::back_inserter(curves),
                 [&](int e) { return opposite[e].curve; });
  std::vector<std::pair<int, int>> pairs;
  for (const int e : side.mesh.elementsOf(pair.side.boundary))
    for (const double t : besideSingular(side, e))
      if (const auto there = oppositeTo(scene, pair, side.mesh[e].curve, t, curves))
        pairs.emplace_back(e, numbers[there->curve]);
  return pairs;
}

}  // namespace

void shareSingularPoints(const Scene& scene, std::vector<SingularMesh>& meshes) {
  std::vector<std::vector<adaptivity::EdgePlace>> found(meshes.size());
  for (std::size_t b = 0; b < meshes.size(); ++b)
    for (const RequiredNode& node : scene.bodies[b].nodes)
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

}  // namespace epafi::drivers
