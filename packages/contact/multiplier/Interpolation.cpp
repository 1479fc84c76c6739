#include "contact/multiplier/Interpolation.hpp"

#include "bem/base/Error.hpp"

#include <utility>

namespace epafi::contact {

using bem::Index;
using bem::Vector;

bem::LuFactor interpolation(const MultiplierBasis& basis, const Vector& places) {
  const auto n = static_cast<Index>(places.size());
  bem::Matrix values(n, n);
  for (Index k = 0; k < n; ++k) {
    const Vector row = basis.values(static_cast<int>(n) - 1, places[k]);
    for (Index j = 0; j < n; ++j)
      values(k, j) = row[j];
  }
  bem::LuFactor factor(std::move(values));
  if (!factor.isRegular())
    throw bem::NumericalError("the multiplier's basis is linearly dependent");
  return factor;
}

}  // namespace epafi::contact
