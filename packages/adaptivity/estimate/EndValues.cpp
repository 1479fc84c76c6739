#include "adaptivity/estimate/EndValues.hpp"

#include "bem/basis/Legendre.hpp"

#include <array>

namespace epafi::adaptivity {

EndValues endValues(int degree, double t) {
  std::array<double, bem::largestDegree + 1> legendre{};
  bem::legendreValues(degree, t, legendre.data());
  double sums[2] = {};  // of even degrees, which are even functions, and of odd ones
  for (std::size_t k = 0; k <= static_cast<std::size_t>(degree); ++k)
    sums[k % 2] += (static_cast<double>(k) + 0.5) * legendre[k];
  return {sums[0] - sums[1], sums[0] + sums[1]};
}

bem::Vec2 valueAt(const AtEnds& factors, const bem::Element& element, double t) {
  const EndValues e = endValues(element.degree, t);
  return (e.start / element.half) * factors.start + (e.end / element.half) * factors.end;
}

}  // namespace epafi::adaptivity
