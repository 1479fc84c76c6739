#include "contact/multiplier/MultiplierBasis.hpp"

#include "bem/base/Error.hpp"
#include "bem/basis/Legendre.hpp"
#include "bem/quadrature/Gauss.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <numeric>
#include <utility>

namespace epafi::contact {

using bem::Index;
using bem::Vector;

namespace {

// The zeros of P_{q+1}.
Vector gaussPlaces(int degree) { return bem::gaussLegendre(degree + 1).points; }

// One step of Newton's method for P_q'(t) = 0, |t| < 1; P_q'' by Legendre's equation.
double lobattoCorrection(int degree, double t) {
  double before = 0;
  double value = 1;
  for (int k = 1; k <= degree; ++k)
    before = std::exchange(value, ((2 * k - 1) * t * value - (k - 1) * before) / k);
  const double w = (1 - t) * (1 + t);
  const double slope = degree * (before - t * value) / w;
  return slope * w / (2 * t * slope - degree * (degree + 1.0) * value);
}

// -1, the zeros of P_q', 1, exactly symmetric; the midpoint for q = 0.
Vector lobattoPlaces(int degree) {
  if (degree == 0)
    return {0.0};
  constexpr double pi = boost::math::constants::pi<double>();
  Vector places(degree + 1, 0.0);
  for (int i = 0; 2 * i < degree; ++i) {
    double t = -std::cos(pi * i / degree);
    for (int step = 0; i > 0 && step < 20; ++step) {
      const double change = lobattoCorrection(degree, t);
      t -= change;
      if (std::abs(change) < 1e-15)
        break;
    }
    places[i] = t;
    places[degree - i] = -t;
  }
  return places;
}

/// Lagrange polynomials by the barycentric formula, stable for every degree.
///                                                  [Berrut & Trefethen 2004, (4.2)]
class Lagrange {
 public:
  explicit Lagrange(Vector nodes) : nodes_(std::move(nodes)), weights_(nodes_.size(), 1) {
    // The capacity of [-1, 1] is 1/2: factors 2 (x_i - x_j) prevent overflow.
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      for (std::size_t j = 0; j < nodes_.size(); ++j)
        if (j != i)
          weights_[i] /= 2 * (nodes_[i] - nodes_[j]);
  }

  const Vector& nodes() const { return nodes_; }

  Vector at(double t) const {
    Vector values(nodes_.size());
    double sum = 0;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (t == nodes_[i]) {
        values.assign(nodes_.size(), 0.0);
        values[i] = 1;
        return values;
      }
      values[i] = weights_[i] / (t - nodes_[i]);
      sum += values[i];
    }
    for (double& value : values)
      value /= sum;
    return values;
  }

 private:
  Vector nodes_;
  Vector weights_;
};

/// By degree, up to bem::largestDegree.
std::vector<Lagrange> lagrangeAt(Vector (*places)(int degree)) {
  std::vector<Lagrange> all;
  for (int degree = 0; degree <= bem::largestDegree; ++degree)
    all.emplace_back(places(degree));
  return all;
}

Vector gaussValues(int degree, double t) {
  static const std::vector<Lagrange> functions = lagrangeAt(gaussPlaces);
  return functions[degree].at(t);
}

const Lagrange& lobatto(int degree) {
  static const std::vector<Lagrange> functions = lagrangeAt(lobattoPlaces);
  return functions[degree];
}

Vector lobattoValues(int degree, double t) { return lobatto(degree).at(t); }

// Dual to Lagrange's functions θ_j at the Gauss-Lobatto points x_i with weights w_i:
//   ∫ χ_i θ_j dt = w_i δ_ij,   χ_i = w_i Σ_k (k + 1/2) P_k(x_i) P_k(t),  k = 0 ... q,
// since the sum reproduces θ_j(x_i).  w_i = ∫ θ_i dt = 2 / (q (q+1) P_q(x_i)²).
//                                                       [Banz & Stephan 2015;
//                                                       DLMF 3.5(v)]
Vector dualValues(int degree, double t) {
  const Vector& nodes = lobatto(degree).nodes();
  Vector atNode(nodes.size());
  Vector here(nodes.size());
  bem::legendreValues(degree, t, here.data());
  Vector values;
  for (const double x : nodes) {
    bem::legendreValues(degree, x, atNode.data());
    const double last = atNode.back();
    const double weight = degree == 0 ? 2 : 2 / (degree * (degree + 1.0) * last * last);
    double sum = 0;
    for (std::size_t k = 0; k < nodes.size(); ++k)
      sum += (static_cast<double>(k) + 0.5) * atNode[k] * here[k];
    values.push_back(weight * sum);
  }
  return values;
}

Vector controlPoints(int degree) {
  Vector points;
  for (int i = 0; i <= degree; ++i)
    points.push_back(degree == 0 ? 0.0 : -1 + 2.0 * i / degree);
  return points;
}

// B_i = binomial(q, i) x^i (1-x)^(q-i), x = (1+t)/2, by the recurrence in q: sums of
// nonnegative terms only.
Vector bernsteinValues(int degree, double t) {
  const double x = 0.5 * (1 + t);
  const double y = 0.5 * (1 - t);
  Vector values = {1.0};
  for (int q = 1; q <= degree; ++q) {
    values.push_back(0.0);
    for (std::size_t i = values.size(); i-- > 0;)
      values[i] = y * values[i] + (i > 0 ? x * values[i - 1] : 0.0);
  }
  return values;
}

// max over t of Σ_i |B_i*(t)| ∫ B_i, B_i*: the dual functions; attained at the ends.
double bernsteinAmplification(int degree) { return std::ldexp(1.0, degree + 1) - 1; }

}  // namespace

bem::Family<MultiplierBasis>& multiplierBases() {
  static bem::Family<MultiplierBasis> bases(
      "multiplier",
      {
          {"Gauss-Legendre-Lagrange", "Lagrange's functions at Gauss-Legendre points",
           gaussPlaces, gaussValues},
          {"Gauss-Lobatto-Lagrange", "Lagrange's functions at Gauss-Lobatto points",
           lobattoPlaces, lobattoValues},
          {"Bernstein",
           "Bernstein's polynomials: nonnegative coefficients mean a nonnegative "
           "pressure",
           controlPoints, bernsteinValues, false, true, 14, bernsteinAmplification},
          {"Biorthogonal",
           "dual to the displacement at Gauss-Lobatto points, one coefficient for each "
           "of its free nodes; implies Form None",
           lobattoPlaces, dualValues, true},
      });
  return bases;
}

const MultiplierBasis& multiplierBasis(const std::string& name) {
  return multiplierBases().at(name);
}

bem::SchemaRow multiplierRow() {
  return bem::Row("Multiplier", bem::Kind::Text,
                  "basis of the contact stress; " + meanings(multiplierBases()))
      .defaultValue(multiplierBases().front().name)
      .allowed(multiplierBases().names());
}

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

namespace {

using Bound = std::function<double(double)>;

Vector valuesAt(const Vector& places, const Bound& bound) {
  Vector values;
  for (const double t : places)
    values.push_back(bound(t));
  return values;
}

double largestError(const MultiplierBasis& basis, const Vector& coefficients,
                    const Vector& places, const Vector& values) {
  const int degree = static_cast<int>(coefficients.size()) - 1;
  double largest = 0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Vector chi = basis.values(degree, places[k]);
    const double value =
        std::inner_product(chi.begin(), chi.end(), coefficients.begin(), 0.0);
    largest = std::max(largest, std::abs(value - values[k]));
  }
  return largest;
}

}  // namespace

Vector boundCoefficients(const MultiplierBasis& basis, int degree, const Bound& bound) {
  Vector values = valuesAt(basis.places(degree), bound);
  if (!basis.controlPoints || degree < 2)
    return values;
  const Vector nodes = multiplierBasis("Gauss-Lobatto-Lagrange").places(degree);
  Vector closer = valuesAt(nodes, bound);
  const Vector& places = bem::gaussForGiven(degree).points;
  const Vector samples = valuesAt(places, bound);
  Vector all = samples;
  all.insert(all.end(), closer.begin(), closer.end());
  const auto range = std::minmax_element(all.begin(), all.end());

  interpolation(basis, nodes).solve(closer);
  for (double& coefficient : closer)
    coefficient = std::max(coefficient, 0.0);
  const bool isWithin = std::all_of(closer.begin(), closer.end(), [&](double c) {
    return *range.first <= c && c <= *range.second;
  });
  constexpr double clearlyCloser = 0.25;
  const bool isCloser =
      largestError(basis, closer, places, samples) <=
      (isWithin ? 1 : clearlyCloser) * largestError(basis, values, places, samples);
  return isCloser ? closer : values;
}

}  // namespace epafi::contact
