#include "contact/multiplier/BoundCoefficients.hpp"

#include "bem/algebra/Blas.hpp"
#include "bem/base/Error.hpp"
#include "bem/base/Matrix.hpp"
#include "bem/quadrature/Gauss.hpp"

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

// The polynomial through the values at the nodes, in the basis.
Vector interpolant(const MultiplierBasis& basis, const Vector& nodes, Vector values) {
  const int n = static_cast<int>(nodes.size());
  bem::Matrix collocation(n, n);
  for (int i = 0; i < n; ++i) {
    const Vector row = basis.values(n - 1, nodes[static_cast<std::size_t>(i)]);
    for (int j = 0; j < n; ++j)
      collocation(i, j) = row[static_cast<std::size_t>(j)];
  }
  const int stride = static_cast<int>(collocation.stride());
  const int one = 1;
  std::vector<int> pivots(nodes.size());
  int info = 0;
  dgesv_(&n, &one, collocation.data(), &stride, pivots.data(), values.data(), &n, &info);
  if (info != 0)
    throw bem::NumericalError("the multiplier's basis is linearly dependent");
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

bool withinHull(const Vector& coefficients, const Vector& first, const Vector& second) {
  const auto [low, high] = std::minmax_element(first.begin(), first.end());
  const auto [lower, higher] = std::minmax_element(second.begin(), second.end());
  const double least = std::min(*low, *lower);
  const double most = std::max(*high, *higher);
  return std::all_of(coefficients.begin(), coefficients.end(),
                     [&](double c) { return least <= c && c <= most; });
}

}  // namespace

Vector boundCoefficients(const MultiplierBasis& basis, int degree, const Bound& bound) {
  Vector values = valuesAt(basis.places(degree), bound);
  if (!basis.controlPoints || degree < 2)
    return values;
  const Vector nodes = multiplierBasis("Gauss-Lobatto-Lagrange").places(degree);
  const Vector atNodes = valuesAt(nodes, bound);
  Vector closer = interpolant(basis, nodes, atNodes);
  for (double& coefficient : closer)
    coefficient = std::max(coefficient, 0.0);

  const Vector& places = bem::gaussLegendre(degree + 12).points;
  const Samples samples{places, valuesAt(places, bound)};
  const double share = withinHull(closer, atNodes, samples.values) ? 1 : clearlyCloser;
  const bool isCloser = largestError(basis, closer, samples) <=
                        share * largestError(basis, values, samples);
  return isCloser ? closer : values;
}

}  // namespace epafi::contact
