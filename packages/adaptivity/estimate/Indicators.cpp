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

Indicators largest(const std::vector<Indicators>& all) {
  Indicators result = all.front();
  Vector totals = result.elements();
  for (std::size_t k = 1; k < all.size(); ++k) {
    const Vector others = all[k].elements();
    for (std::size_t e = 0; e < totals.size(); ++e)
      if (others[e] > totals[e]) {
        totals[e] = others[e];
        result.squares[e] = all[k].squares[e];
      }
  }
  return result;
}

}  // namespace epafi::adaptivity
