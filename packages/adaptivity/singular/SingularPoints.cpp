#include "adaptivity/singular/SingularPoints.hpp"

#include "bem/geometry/Continuation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace epafi::adaptivity {

using contact::ContactState;

namespace {

bool isSupport(const bem::Mesh& mesh, int e, const contact::Conditions& conditions) {
  const auto contact = conditions.contact.find(mesh.boundary(e));
  return contact != conditions.contact.end() && contact->second.isSupport;
}

bool isHeld(const bem::Mesh& mesh, int e, const contact::Conditions& conditions) {
  return conditions.dirichlet.count(mesh.boundary(e)) > 0 ||
         isSupport(mesh, e, conditions);
}

bool touches(const bem::Mesh& mesh, int e, const contact::Conditions& conditions) {
  const bem::Piece& piece = mesh[e].piece;
  return contactOn(mesh, e, conditions) != nullptr ||
         conditions.faces(piece.edge, piece.start.fromStart, piece.end.fromStart);
}

Singularity fromConditions(const bem::Mesh& mesh, int e,
                           const contact::Conditions& conditions) {
  if (contact::beginsAtImage(mesh, e, conditions))
    return Singularity::None;
  const int before = mesh[e].previous;
  // where a line of symmetry begins or ends the side meets its image: smoothly at a right angle,
  // as the other face of a crack where it goes on
  const bool isImage = !conditions.isBoundary(mesh.boundary(e));
  if (isImage != !conditions.isBoundary(mesh.boundary(before))) {
    if (bem::joinSmoothly(mesh[before].curve, mesh[e].curve))
      return Singularity::Strong;
    return std::abs(dot(mesh[before].curve.tangent(1), mesh[e].curve.tangent(-1))) <
                   bem::smoothAngle / 2
               ? Singularity::None
               : Singularity::Weak;
  }
  const bool isSmooth = bem::joinSmoothly(mesh[before].curve, mesh[e].curve);
  const auto differs = [&](const auto& of) {
    return of(mesh, e, conditions) != of(mesh, before, conditions);
  };
  if (mesh.boundary(e) != mesh.boundary(before))
    return differs(isHeld) || (isSmooth && differs(isSupport)) ? Singularity::Strong
                                                               : Singularity::Weak;
  // where what is opposite ends, the pressure does
  if (differs(contact::contactOn))
    return Singularity::Strong;
  if (!isSmooth)
    return Singularity::Weak;
  // the slope of the pressure is unbounded
  return touches(mesh, e, conditions) &&
                 !bem::haveOneCurvature(mesh[before].curve, mesh[e].curve)
             ? Singularity::Strong
             : Singularity::None;
}

/// States of coefficient i of an element, of pressure and shear.  If the slip bound depends on the
/// pressure, an open point has no friction.
std::pair<ContactState, ContactState> statesOf(
    const contact::MultiplierSpace::ContactElement& element, int i,
    const contact::ContactStates& states) {
  if (element.ties())
    return {ContactState::Closed, ContactState::Stick};
  const ContactState normal = states[element.normalOf(i)];
  const contact::Friction& friction = element.condition->friction;
  const bool idle =
      normal == ContactState::Open && friction && friction.law->dependsOnPressure();
  if (!element.shears() || idle)
    return {normal, ContactState::Frictionless};
  return {normal, states[element.tangentialOf(i)]};
}

}  // namespace

SingularPoints findSingularPoints(const bem::Mesh& mesh,
                                  const contact::Conditions& conditions) {
  SingularPoints points;
  points.inside.resize(mesh.size());
  for (int e = 0; e < mesh.size(); ++e)
    points.nodes.push_back(fromConditions(mesh, e, conditions));
  return points;
}

SingularPoints findSingularPoints(const bem::Mesh& mesh,
                                  const contact::Conditions& conditions,
                                  const contact::MultiplierSpace& multiplier,
                                  std::size_t body,
                                  const contact::ContactStates& states) {
  SingularPoints points = findSingularPoints(mesh, conditions);

  const auto& elements = multiplier.elements(body);
  for (const auto& element : elements) {
    const auto places = multiplier.basis().places(element.degree);
    if (element.follower && statesOf(element, element.degree, states) !=
                                statesOf(elements[*element.follower], 0, states))
      points.nodes[mesh[element.element].endNode] = Singularity::Strong;
    for (int i = 0; i < element.degree; ++i)
      if (statesOf(element, i, states) != statesOf(element, i + 1, states))
        points.inside[element.element].push_back(0.5 * (places[i] + places[i + 1]));
  }
  return points;
}

SingularPoints united(const std::vector<SingularPoints>& all) {
  constexpr double apart = 0.2;  // a tenth of an element, in t
  SingularPoints result = all.front();
  for (std::size_t k = 1; k < all.size(); ++k) {
    const SingularPoints& more = all[k];
    for (std::size_t n = 0; n < result.nodes.size(); ++n)
      result.nodes[n] = std::max(result.nodes[n], more.nodes[n]);
    for (std::size_t e = 0; e < result.inside.size(); ++e) {
      std::vector<double>& inside = result.inside[e];
      const std::vector<double> known = inside;
      for (const double t : more.inside[e])
        if (std::none_of(known.begin(), known.end(),
                         [t](double other) { return std::abs(t - other) < apart; }))
          inside.insert(std::upper_bound(inside.begin(), inside.end(), t), t);
    }
    result.states += more.states;
  }
  return result;
}

SingularPoints withStrong(SingularPoints points, const bem::Mesh& mesh,
                          const std::vector<EdgePlace>& places) {
  constexpr double close = 0.01;
  constexpr double rounding = 1e-12;  // of a place, in diameters
  for (const EdgePlace& place : places)
    for (int e = 0; e < mesh.size(); ++e) {
      const bem::Element& element = mesh[e];
      const double t =
          (place.fromStart - element.piece.start.fromStart) / element.half - 1;
      if (element.piece.edge != place.edge || std::abs(t) > 1 + rounding / element.half)
        continue;
      std::vector<double>& inside = points.inside[e];
      if (1 + t < 2 * close)
        points.nodes[element.startNode] = Singularity::Strong;
      else if (1 - t < 2 * close)
        points.nodes[element.endNode] = Singularity::Strong;
      else if (std::none_of(inside.begin(), inside.end(), [t](double other) {
                 return std::abs(t - other) < 2 * close;
               }))
        inside.insert(std::upper_bound(inside.begin(), inside.end(), t), t);
    }
  return points;
}

}  // namespace epafi::adaptivity
