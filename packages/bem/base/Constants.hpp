#pragma once

namespace epafi::bem {

/// 1/2π, the factor of Laplace's potentials in the plane.
constexpr double inverse2Pi = 0.15915494309189533577;

}  // namespace epafi::bem
