#include "adaptivity/estimate/Indicators.hpp"

#include <cmath>
#include <numeric>

namespace epafi::adaptivity {

Vector Indicators::elements() const {
  Vector totals;
  for (const Contributions& square : squares)
    totals.push_back(std::accumulate(square.begin(), square.end(), 0.0));
  return totals;
}

Contributions Indicators::sums() const {
  Contributions sums{};
  for (const Contributions& square : squares)
    for (std::size_t k = 0; k < sums.size(); ++k)
      sums[k] += square[k];
  return sums;
}

double Indicators::estimate() const {
  const Vector totals = elements();
  return std::sqrt(std::accumulate(totals.begin(), totals.end(), 0.0));
}

}  // namespace epafi::adaptivity
