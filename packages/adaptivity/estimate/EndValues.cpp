#include "adaptivity/estimate/EndValues.hpp"

#include "bem/basis/Legendre.hpp"

#include <array>

namespace epafi::adaptivity {

double endValue(int degree, double t) {
  std::array<double, bem::largestDegree + 1> legendre{};
  bem::legendreValues(degree, t, legendre.data());
  double sum = 0;
  for (std::size_t k = 0; k <= static_cast<std::size_t>(degree); ++k)
    sum += (static_cast<double>(k) + 0.5) * legendre[k];
  return sum;
}

bem::Vec2 valueAt(const AtEnds& factors, const bem::Element& element, double t) {
  return (endValue(element.degree, -t) / element.half) * factors.start +
         (endValue(element.degree, t) / element.half) * factors.end;
}

}  // namespace epafi::adaptivity
