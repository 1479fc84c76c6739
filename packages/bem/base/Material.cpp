#include "bem/base/Material.hpp"

#include "bem/base/Error.hpp"

#include <boost/math/constants/constants.hpp>

namespace epafi::bem {

Lame::Lame(const Material& material, double stress) : nu(material.poissonsRatio) {
  if (!(nu > -1 && nu <= 0.5))
    throw InputError("Poisson's Ratio = ", nu, " must lie in (-1, 1/2]");
  mu = material.youngsModulus / stress / (2 * (1 + nu));  // in both plane states
  if (material.planeStress)
    nu = nu / (1 + nu);
  constexpr double pi = boost::math::constants::pi<double>();
  b = 1 / (8 * pi * mu * (1 - nu));
  a = (3 - 4 * nu) * b;
  d = mu / (2 * pi * (1 - nu));
}

}  // namespace epafi::bem
