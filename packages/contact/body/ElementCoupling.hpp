#pragma once

#include "contact/body/Coupling.hpp"

namespace epafi::contact {

/// Adds what one contact element has of C, G and M to a coupling; with densities by
/// Legendre polynomials in G's rows where `byDensity`, else tractions by orthonormal ones.
///
/// \param firstRow  of G where the element's begin
void addElement(const bem::Space& space, const MultiplierBasis& basis, bool byDensity,
                const MultiplierSpace::ContactElement& contact, double gamma,
                Index firstRow, Coupling& coupling);

/// What the traction t_p of a particular solution does through the residual λ + t_p + S u.
struct TractionMoments {
  Vector weights;      ///< by G's rows: <γ t_p, P> as G λ has <γ λ, P>
  Vector multipliers;  ///< <γ t_p, χ_i> as M λ has <γ λ, χ_i>
};
TractionMoments tractionMoments(const bem::Space& space,
                                const MultiplierSpace& multiplier, bool byDensity,
                                const Coupling& coupling,
                                const ParticularSolution& inside);

}  // namespace epafi::contact
