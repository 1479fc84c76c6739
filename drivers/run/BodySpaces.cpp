#include "drivers/run/BodySpaces.hpp"

#include "adaptivity/refine/LineOfSymmetry.hpp"
#include "bem/base/Error.hpp"
#include "contact/conditions/Conduction.hpp"
#include "contact/stabilization/StabilisedStiffness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace epafi::drivers {

BodySpaces::BodySpaces(const Scene& scene, const Level& level) : scene_(scene) {
  const std::size_t count = level.meshes.size();
  spaces_.reserve(count);  // what refers to them follows
  std::vector<contact::MultiplierSpace::Body> bodies;
  for (std::size_t b = 0; b < count; ++b) {
    const contact::Conditions& conditions = scene.bodies[b].conditions;
    spaces_.push_back(contact::makeSpace({scene.bodies[b].outline, level.meshes[b]},
                                         conditions, scene.stabilization));
    bodies.push_back({spaces_.back().mesh(), conditions});
  }
  multiplier_.emplace(bodies, contact::multiplierBasis(scene.multiplier));
  std::map<std::string, contact::OppositeSide> sides;
  for (const ContactPair& pair : scene.contacts)
    sides.emplace(pair.name, oppositeSide(pair));
  opposite_ = std::make_shared<const contact::Opposite>(*multiplier_,
                                                        scene.units().length, sides);
}

std::vector<const bem::Space*> BodySpaces::all() const {
  std::vector<const bem::Space*> all;
  for (const bem::Space& space : spaces_)
    all.push_back(&space);
  return all;
}

contact::OppositeSide BodySpaces::oppositeSide(const ContactPair& pair) const {
  contact::OppositeSide opposite;
  opposite.shift = scene_.shift(pair);
  opposite.visibility = scene_.visibility(pair);
  if (pair.opposite.rigid) {
    const RigidBody& body = scene_.rigid[pair.opposite.body];
    const double length = scene_.units().length;
    const Scene::OppositeEdges edges = scene_.oppositeEdges(pair);
    opposite.curves = edges.curves;
    const double unit = length / body.outline->scaling().length;
    const std::vector<bem::Continuations> beyond = bem::continuations(*body.outline);
    for (const int e : edges.edges)
      opposite.beyond.push_back(beyond[bem::at(e)].inUnits(unit));
    opposite.rigid = static_cast<int>(pair.opposite.body);
    opposite.pole = (1 / length) * (body.pole - body.outline->scaling().origin);
    return opposite;
  }
  opposite.body = static_cast<int>(pair.opposite.body);
  const bem::Mesh& mesh = spaces_[pair.opposite.body].mesh();
  std::vector<bem::Curve> curves;
  const std::vector<bem::Continuations> beyond = bem::continuations(mesh.outline());
  for (const int e : mesh.elementsOf(pair.opposite.boundary)) {
    curves.push_back(mesh[e].curve);
    opposite.elements.push_back(e);
    opposite.degrees.push_back(mesh[e].degree);
    const bem::Piece& piece = mesh[e].piece;
    opposite.beyond.push_back(beyond[bem::at(piece.edge)].ofPart(piece.start, piece.end));
  }
  opposite.curves = bem::CurveTree(std::move(curves));
  return opposite;
}

std::vector<contact::Conditions> BodySpaces::conditionsAt(double t) const {
  std::vector<contact::Conditions> all = scene_.conditionsAt(t);
  for (std::size_t b = 0; b < all.size(); ++b)
    if (all[b].heat) {
      auto& conduction = conductions_[b];
      if (!conduction)
        conduction =
            std::make_shared<const contact::Conduction>(spaces_[b].mesh(), *all[b].heat);
      all[b].inside = std::make_shared<const contact::ParticularSolution>(
          *all[b].inside, conduction->heat(*all[b].heat));
    }
  return all;
}

LevelRow BodySpaces::levelRow() const {
  LevelRow row;
  row.contacts = stepRow().contacts;
  row.multipliers = multiplier_->size();
  row.degreeMin = bem::largestDegree;
  row.sizeMin = std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b < size(); ++b) {
    const bem::Mesh& mesh = spaces_[b].mesh();
    const double diameter = mesh.outline().scaling().length;
    row.elements += mesh.size();
    row.displacements +=
        contact::freeDisplacements(spaces_[b], scene_.bodies[b].conditions);
    row.densities += spaces_[b].densities();
    for (const bem::Element& element : mesh.elements()) {
      row.degreeMin = std::min(row.degreeMin, element.degree);
      row.degreeMax = std::max(row.degreeMax, element.degree);
      row.sizeMin = std::min(row.sizeMin, 2 * element.half * diameter);
      row.sizeMax = std::max(row.sizeMax, 2 * element.half * diameter);
    }
  }
  return row;
}

StepRow BodySpaces::stepRow() const {
  StepRow row;
  std::map<std::string, int> uses;  // of a name
  for (const RigidBody& body : scene_.rigid) {
    row.rigid.emplace_back(body.name, contact::Summary());
    ++uses[body.name];
  }
  std::vector<std::set<std::string>> contacts(size());
  for (std::size_t b = 0; b < size(); ++b) {
    for (const auto& element : multiplier_->elements(b))
      contacts[b].insert(contact::nameOf(element));
    for (const std::string& name : contacts[b])
      ++uses[name];
  }
  for (std::size_t b = 0; b < size(); ++b)
    for (const std::string& name : contacts[b])
      row.contacts.emplace_back(
          uses[name] > 1 ? bem::message(scene_.bodies[b].name, ":", name) : name,
          contact::Summary());
  return row;
}

contact::Motions BodySpaces::motions(
    const std::vector<bem::Vector>& displacements,
    const std::vector<contact::RigidMotion>& rigid) const {
  contact::Motions motions;
  motions.rigid = rigid;
  for (std::size_t b = 0; b < size(); ++b) {
    motions.displacements.emplace_back(spaces_[b], displacements[b]);
    motions.shearModuli.push_back(scene_.lame(b).mu);
  }
  return motions;
}

namespace {

/// An edge in equal elements between its required nodes, about `count` of them in all.
void cutEdge(int edge, double length, int count, int degree, bem::Vector nodes,
             std::vector<bem::Piece>& pieces) {
  std::sort(nodes.begin(), nodes.end());
  nodes.push_back(length);
  double start = 0;
  bem::Position from{0, length};
  for (const double end : nodes) {
    // Halves go up however they are rounded: what is symmetric gets a symmetric mesh.
    constexpr double upward = 0.5 + 1e-9;
    const int parts = std::max(
        1, static_cast<int>(std::floor(count * (end - start) / length + upward)));
    for (int k = 1; k <= parts; ++k) {
      const double place = start + (end - start) * k / parts;
      const bool last = k == parts && end == length;
      const bem::Position to =
          last ? bem::Position{length, 0} : bem::Position{place, length - place};
      pieces.push_back({edge, from, to, degree});
      from = to;
    }
    start = end;
  }
}

bem::Mesh ungradedMesh(const Body& body) {
  if (body.nodes.empty())
    return bem::makeMesh(body.outline, body.elementsPerEdge, body.degree);
  std::vector<bem::Piece> pieces;
  for (std::size_t e = 0; e < body.outline->edges().size(); ++e) {
    bem::Vector nodes;
    for (const RequiredNode& node : body.nodes)
      if (node.edge == static_cast<int>(e))
        nodes.push_back(node.place);
    cutEdge(static_cast<int>(e), body.outline->edges()[e].curve.length(),
            body.elementsPerEdge[e], body.degree, std::move(nodes), pieces);
  }
  return {body.outline, pieces};
}

/// Linear displacements on an arc that turns by a [radian] miss a^2/8 of the body's growth, so
/// that two meshes of one circle press on each other at their nodes.  Where an element of the
/// edge misses more than 0.01, the degree is 2; next to a required node, too.
int leastDegree(const Body& body, int edge) {
  constexpr double missed = 0.01;
  const double angle =
      body.outline->edge(edge).curve.angle() / body.elementsPerEdge[edge];
  return angle * angle / 8 > missed ? 2 : 1;
}

}  // namespace

bem::Mesh firstMesh(const Body& body) {
  std::vector<bem::Piece> pieces = piecesOf(ungradedMesh(body));
  for (bem::Piece& piece : pieces)
    piece.degree = std::max(piece.degree, leastDegree(body, piece.edge));
  return adaptivity::gradedLines({body.outline, pieces}, body.conditions);
}

Level firstMeshes(const Scene& scene) {
  Level level;
  for (const Body& body : scene.bodies)
    level.meshes.push_back(piecesOf(firstMesh(body)));
  return level;
}

std::vector<bem::Piece> piecesOf(const bem::Mesh& mesh) {
  std::vector<bem::Piece> pieces;
  for (const bem::Element& element : mesh.elements())
    pieces.push_back(element.piece);
  return pieces;
}

}  // namespace epafi::drivers
