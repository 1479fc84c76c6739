#pragma once

#include "contact/body/Coupling.hpp"

namespace epafi::contact {

/// Adds what contact element k has of C, G and M to a coupling; with densities by
/// Legendre polynomials in G's rows where `byDensity`, else tractions by orthonormal ones.
///
/// \pre the coupling has its γ, and the row of G where its tractions start
void addElement(const bem::Space& space, const MultiplierSpace& multiplier, std::size_t k,
                bool byDensity, Coupling& coupling);

}  // namespace epafi::contact
