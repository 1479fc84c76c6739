#pragma once

#include "bem/base/Vec2.hpp"
#include "bem/quadrature/LegendreSeries.hpp"
#include "bem/space/Space.hpp"

namespace epafi::bem {

/// u, du/ds and ψ on one element as Legendre series in t; a vector (x, y) is the complex
/// number x + iy.
struct LocalField {
  LegendreSeries<Complex> value{};    ///< 0 ... p
  LegendreSeries<Complex> slope{};    ///< 0 ... p - 1
  LegendreSeries<Complex> density{};  ///< 0 ... densities - 1
};

/// Polynomial parts on element e; for potentials on arcs pass Space::withoutRotation(u).
LocalField localField(const Space& space, const Vector& u, const Vector& psi, int e);

}  // namespace epafi::bem
