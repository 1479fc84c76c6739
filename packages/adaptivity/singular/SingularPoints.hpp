#pragma once

#include "bem/mesh/Mesh.hpp"
#include "contact/equation/ContactState.hpp"
#include "contact/multiplier/MultiplierSpace.hpp"

#include <vector>

namespace epafi::adaptivity {

/// How badly the solution behaves at a node.
enum class Singularity {
  None,
  Weak,   ///< a corner, or where two boundaries or two kinds of condition meet
  Strong  ///< where a clamp ends, or where contact or friction changes its state
};

/// The finitely many points between which the solution is analytic, as far as they show.
struct SingularPoints {
  /// Of each element's start node.
  std::vector<Singularity> nodes;
  /// Places in (-1, 1) of each element where a contact or friction state changes: between
  /// two coefficients of the multiplier in different states, in the middle.
  std::vector<std::vector<double>> inside;
  /// Of how many states they are: those of several lie where contact and stick end in turn.
  int states = 1;

  Singularity at(const bem::Mesh& mesh, int element, bool end) const {
    const bem::Element& e = mesh[element];
    return nodes[end ? e.endNode : e.startNode];
  }
};

/// Those that the conditions alone tell.
SingularPoints findSingularPoints(const bem::Mesh& mesh,
                                  const contact::Conditions& conditions);

/// And those of the solution.
SingularPoints findSingularPoints(const bem::Mesh& mesh,
                                  const contact::Conditions& conditions,
                                  const contact::MultiplierSpace& multiplier,
                                  const contact::ContactState& states);

/// Those of all states that they belong to, on one mesh: a node is as bad as the worst of them
/// makes it, and places closer than a tenth of an element are one, the first state's.
/// \pre at least one
SingularPoints united(const std::vector<SingularPoints>& all);

/// A place on an edge of the outline.
struct EdgePlace {
  int edge = 0;
  double fromStart = 0;  ///< [outline diameters]
};

/// With further strong ones: less than one percent of an element away from a node such a place is at
/// the node, and as close to another one of the element it is that one.
SingularPoints withStrong(SingularPoints points, const bem::Mesh& mesh,
                          const std::vector<EdgePlace>& places);

/// What the place of a multiplier's coefficient does.
struct PointState {
  contact::NormalState normal = contact::NormalState::Open;
  contact::FrictionState friction = contact::FrictionState::None;

  bool operator==(const PointState& other) const {
    return normal == other.normal && friction == other.friction;
  }
  bool operator!=(const PointState& other) const { return !(*this == other); }
};

/// Of coefficient i of an element.  Under a law that follows the pressure an open point
/// has no friction state of its own.
PointState pointState(const contact::MultiplierSpace& multiplier,
                      const contact::MultiplierSpace::ContactElement& element, int i,
                      const contact::ContactState& states);

}  // namespace epafi::adaptivity
