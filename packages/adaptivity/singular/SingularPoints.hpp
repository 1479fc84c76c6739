#pragma once

#include "bem/mesh/Mesh.hpp"
#include "contact/multiplier/MultiplierSpace.hpp"
#include "contact/problem/ContactState.hpp"

#include <vector>

namespace epafi::adaptivity {

/// Strength of the singularity of the solution at a node.
enum class Singularity {
  None,
  Weak,  ///< a corner, or where two boundaries or two kinds of condition meet
  Strong  ///< where a clamp ends, where contact or friction changes its state, and where the
          ///< curvature does within a contact
};

/// Known points between which the solution is analytic.
struct SingularPoints {
  /// By element, of its start node.
  std::vector<Singularity> nodes;
  /// Places in (-1, 1) of each element where a contact or friction state changes: between
  /// two coefficients of the multiplier in different states, in the middle.
  std::vector<std::vector<double>> inside;
  /// Number of states whose points are united, see united().
  int states = 1;

  Singularity at(const bem::Mesh& mesh, int element, bool end) const {
    const bem::Element& e = mesh[element];
    return nodes[end ? e.endNode : e.startNode];
  }
};

/// Singular points due to the conditions.
SingularPoints findSingularPoints(const bem::Mesh& mesh,
                                  const contact::Conditions& conditions);

/// Singular points due to the conditions and to transitions of the solution.
SingularPoints findSingularPoints(const bem::Mesh& mesh,
                                  const contact::Conditions& conditions,
                                  const contact::MultiplierSpace& multiplier,
                                  std::size_t body, const contact::ContactStates& states);

/// Union of the singular points of several states on one mesh: the strongest singularity at each
/// node; places closer than a tenth of an element are merged to that of the first state.
/// \pre not empty
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

}  // namespace epafi::adaptivity
