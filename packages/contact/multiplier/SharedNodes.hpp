#pragma once

#include "contact/multiplier/MultiplierSpace.hpp"

#include <map>

namespace epafi::contact {

/// Directions in which the displacements of nodes are constrained.
class NodeDirections {
 public:
  /// Component of `direction` orthogonal to the constrained directions of the node.
  bem::Vec2 rest(int node, bem::Vec2 direction) const;

  /// Constrains rest(node, direction) and returns true, if its norm is at least 1e-2 for a unit
  /// vector; else returns false.
  bool take(int node, bem::Vec2 direction);

  bool anyAt(int node) const { return taken_.count(node) > 0; }

 private:
  std::map<int, std::vector<bem::Vec2>> taken_;  // orthonormal
};

/// Directions constrained by Dirichlet conditions.
NodeDirections clampedDirections(const bem::Mesh& mesh, const Conditions& conditions);

/// Weights a with  c_end = Σ_i a_i c_i  for the coefficients c of every polynomial of
/// degree p - 1 in the dual basis, i over all but the ends that do not exist:
///
///   a_i = - w_i Q(x_i) / (w_end Q(x_end)),   w_i ~ 1 / P_p(x_i)²,   Q = P_p,
///
/// since  c_i = ∫ q θ_i / w_i  and  Σ_i w_i Q(x_i) c_i = ∫ q Q = 0.  Where neither end
/// exists, Q = P_p - P_{p-1} for the first, P_p + P_{p-1} for the last vanishes at the
/// other, and degree p - 2 is left.  Zero for what does not exist; p >= 2 or one end.
Vector endWeights(int degree, EndCoefficients ends, bool last);

/// The completions of elements whose coefficients are numbered.
///
/// Where an end's coefficient does not exist, the function gets the one that endWeights
/// say.  Under a clamp only the clamp feels it: χ_end is orthogonal to all free θ_j.  At
/// a node that another contact side speaks for, inequalities have the neighbour's value,
/// so that the force on the node is w c_neighbour; the function keeps that force: what
/// its coefficient differs by is taken from those that the node has.
void completeEnds(const bem::Mesh& mesh, const Conditions& conditions,
                  std::vector<MultiplierSpace::ContactElement>& elements);

}  // namespace epafi::contact
