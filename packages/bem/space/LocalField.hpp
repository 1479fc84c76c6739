#pragma once

#include "bem/moments/LegendreMoments.hpp"
#include "bem/space/Space.hpp"

namespace epafi::bem {

/// u, its derivative by arc length and ψ on one element as Legendre series in t; a vector
/// of the plane is x + iy.
struct LocalField {
  std::array<Complex, largestDegree + 1> value{};    ///< 0 ... p
  std::array<Complex, largestDegree + 1> slope{};    ///< 0 ... p - 1
  std::array<Complex, largestDegree + 1> density{};  ///< 0 ... densities - 1
};

LocalField localField(const Space& space, const Vector& u, const Vector& psi, int e);

}  // namespace epafi::bem
