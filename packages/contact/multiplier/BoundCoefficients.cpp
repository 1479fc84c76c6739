#include "contact/multiplier/BoundCoefficients.hpp"

#include "bem/quadrature/Gauss.hpp"
#include "contact/multiplier/Interpolation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace epafi::contact {

namespace {

using bem::Vector;
using Bound = std::function<double(double)>;

constexpr double clearlyCloser = 0.25;

Vector valuesAt(const Vector& places, const Bound& bound) {
  Vector values;
  for (const double t : places)
    values.push_back(bound(t));
  return values;
}

struct Samples {
  Vector places;
  Vector values;
};

double largestError(const MultiplierBasis& basis, const Vector& coefficients,
                    const Samples& samples) {
  const int degree = static_cast<int>(coefficients.size()) - 1;
  double largest = 0;
  for (std::size_t k = 0; k < samples.places.size(); ++k) {
    const Vector chi = basis.values(degree, samples.places[k]);
    const double value =
        std::inner_product(chi.begin(), chi.end(), coefficients.begin(), 0.0);
    largest = std::max(largest, std::abs(value - samples.values[k]));
  }
  return largest;
}

struct Range {
  double least = 0;
  double most = 0;
};

Range join(Range range, const Vector& values) {
  for (const double value : values)
    range = {std::min(range.least, value), std::max(range.most, value)};
  return range;
}

// By how much the outer range exceeds the inner one.
double excess(const Range& inner, const Range& outer) {
  return std::max(inner.least - outer.least, outer.most - inner.most);
}

}  // namespace

Vector boundCoefficients(const MultiplierBasis& basis, int degree, const Bound& bound) {
  Vector values = valuesAt(basis.places(degree), bound);
  if (!basis.controlPoints || degree < 2)
    return values;
  const Vector nodes = multiplierBasis("Gauss-Lobatto-Lagrange").places(degree);
  const Vector atNodes = valuesAt(nodes, bound);
  Vector closer = atNodes;
  interpolation(basis, nodes).solve(closer);
  for (double& coefficient : closer)
    coefficient = std::max(coefficient, 0.0);

  const Vector& places = bem::gaussForGiven(degree).points;
  const Samples samples{places, valuesAt(places, bound)};
  const double first = atNodes.front();
  const Range hull = join(join({first, first}, atNodes), samples.values);
  const double beyond = excess(hull, join(hull, closer));
  const bool isCloser =
      largestError(basis, closer, samples) <=
      (beyond == 0 ? 1 : clearlyCloser) * largestError(basis, values, samples);
  return isCloser ? closer : values;
}

}  // namespace epafi::contact
