#include "bem/base/Material.hpp"

#include "bem/base/Error.hpp"

#include <cmath>

namespace epafi::bem {

Lame::Lame(const Material& material) : nu(material.poissonsRatio) {
  if (!(nu > -1 && nu <= 0.5))
    throw InputError(message("Poisson's Ratio = ", nu, " must lie in (-1, 1/2]"));
  // In units of Young's modulus mu = 1/(2(1+nu)) in both plane states.
  mu = 1 / (2 * (1 + nu));
  if (material.planeStress)
    nu = nu / (1 + nu);
  const double pi = std::acos(-1.0);
  b = 1 / (8 * pi * mu * (1 - nu));
  a = (3 - 4 * nu) * b;
  d = mu / (2 * pi * (1 - nu));
}

}  // namespace epafi::bem
