#pragma once

#include "contact/multiplier/MultiplierSpace.hpp"

namespace epafi::contact {

/// Decides which ends of elements have a coefficient of their own: those whose node has a direction
/// for it that neither clamps nor other coefficients take, normals first.
void chooseEnds(const bem::Mesh& mesh, const Conditions& conditions,
                std::vector<MultiplierSpace::ContactElement>& elements);

/// Weights a of the end's coefficient, c_end = Σ_i a_i c_i for every polynomial of degree
/// p - 1 in the dual basis, so that an element without it has degree p - 1.  i:
/// coefficients that exist.
///
///   a_i = - w_i Q(x_i) / (w_end Q(x_end)),   w_i ~ 1 / P_p(x_i)²,   Q = P_p,
///
/// since  c_i = ∫ q θ_i / w_i  and  Σ_i w_i Q(x_i) c_i = ∫ q Q = 0.  If neither end
/// exists, Q = P_p - P_{p-1} for the first and P_p + P_{p-1} for the last, which vanish
/// at the other end: degree p - 2.  a_i = 0 for coefficients that do not exist.
/// \pre p >= 2, or one end exists
Vector endWeights(const Coefficients& own, bool last);

/// Sets the completions of numbered elements: an end without a coefficient gets that of
/// endWeights().
///
/// At a clamp this changes the reaction only: χ_end is orthogonal to the θ_j of all free
/// nodes.  At a node whose coefficients belong to another contact side, inequalities use
/// the coefficient of the neighbour, so that the force on the node is w c_neighbour.  The
/// completion keeps this force: the coefficients of the node compensate the difference.
void completeEnds(const bem::Mesh& mesh, const Conditions& conditions,
                  std::vector<MultiplierSpace::ContactElement>& elements);

}  // namespace epafi::contact
