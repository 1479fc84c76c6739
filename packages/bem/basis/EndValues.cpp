#include "bem/basis/EndValues.hpp"

#include "bem/basis/Legendre.hpp"

#include <array>

namespace epafi::bem {

EndValues endValues(int degree, double t) {
  std::array<double, largestDegree + 1> legendre{};
  legendreValues(degree, t, legendre.data());
  double sums[2] = {};  // of even degrees, which are even functions, and of odd ones
  for (std::size_t k = 0; k <= static_cast<std::size_t>(degree); ++k)
    sums[k % 2] += (static_cast<double>(k) + 0.5) * legendre[k];
  return {sums[0] - sums[1], sums[0] + sums[1]};
}

}  // namespace epafi::bem
