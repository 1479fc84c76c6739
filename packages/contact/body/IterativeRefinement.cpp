#include "contact/body/IterativeRefinement.hpp"

#include "bem/algebra/SmallAlgebra.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace epafi::contact {

using bem::axpy;

double largestEntry(const bem::Vector& x) {
  double size = 0;
  for (const double entry : x) {
    if (std::isnan(entry))
      return entry;
    size = std::max(size, std::abs(entry));
  }
  return size;
}

bem::Vector refined(bem::Vector u,
                    const std::function<bem::Vector(const bem::Vector&)>& correction) {
  constexpr int mostSteps = 4;
  double last = std::numeric_limits<double>::infinity();
  for (int step = 0; step < mostSteps; ++step) {
    const bem::Vector change = correction(u);
    const double size = largestEntry(change);
    if (!(size < 0.5 * last))
      break;
    axpy(1, change, u);
    last = size;
    if (!(size > roundingOfCorrections * largestEntry(u)))
      break;
  }
  return u;
}

}  // namespace epafi::contact
