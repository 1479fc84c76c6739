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

}  // namespace epafi::contact
