#include "contact/multiplier/BoundCoefficients.hpp"

#include "bem/quadrature/Gauss.hpp"
#include "contact/multiplier/Collocation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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

// By how much the outer range is beyond the inner.
double excess(const Range& inner, const Range& outer) {
  return std::max(inner.least - outer.least, outer.most - inner.most);
}

// A bound as control points: in one way or the other.
struct Choice {
  Vector values;           // at the control points' places
  Vector closer;           // of the polynomial through `atNodes`, none < 0
  Vector nodes;            // Gauss and Lobatto's
  Vector atNodes;          // the bound there
  Range hull;              // of what is known of the bound
  double rounding = 0;     // what makes no difference
  bool isWithin = false;   // is `closer` within the hull, but for rounding?
  bool isCloser = false;   // is it to be taken?
  bool isAsClose = false;  // would it be but for rounding?  Both ways may be exact.
};

Choice choose(const MultiplierBasis& basis, int degree, const Bound& bound) {
  Choice choice;
  choice.values = valuesAt(basis.places(degree), bound);
  choice.nodes = multiplierBasis("Gauss-Lobatto-Lagrange").places(degree);
  choice.atNodes = valuesAt(choice.nodes, bound);
  choice.closer = Collocation(basis, choice.nodes).coefficients(choice.atNodes);
  for (double& coefficient : choice.closer)
    coefficient = std::max(coefficient, 0.0);

  const Vector& places = bem::gaussForGiven(degree).points;
  const Samples samples{places, valuesAt(places, bound)};
  const double first = choice.atNodes.front();
  choice.hull = join(join({first, first}, choice.atNodes), samples.values);
  choice.rounding = 64 * std::numeric_limits<double>::epsilon() * choice.hull.most;
  const double beyond = excess(choice.hull, join(choice.hull, choice.closer));
  choice.isWithin = beyond <= choice.rounding;
  const double error = largestError(basis, choice.closer, samples);
  const double other = largestError(basis, choice.values, samples);
  choice.isCloser = error <= (beyond == 0 ? 1 : clearlyCloser) * other;
  choice.isAsClose =
      error <= (choice.isWithin ? 1 : clearlyCloser) * other + choice.rounding;
  return choice;
}

}  // namespace

Vector boundCoefficients(const MultiplierBasis& basis, int degree, const Bound& bound) {
  if (!basis.controlPoints || degree < 2)
    return valuesAt(basis.places(degree), bound);
  const Choice choice = choose(basis, degree, bound);
  return choice.isCloser ? choice.closer : choice.values;
}

PressureBound pressureBound(const MultiplierBasis& basis, int degree,
                            const Bound& field) {
  PressureBound bound;
  if (!basis.controlPoints || degree < 2) {
    bound.alone = valuesAt(basis.places(degree), field);
    return bound;
  }
  Choice choice = choose(basis, degree, field);
  const Range known = join(choice.hull, choice.values);
  bound.isConstant = known.most - known.least <= choice.rounding;
  bound.isSmooth = choice.isAsClose;
  const Range range = choice.isWithin ? choice.hull : join(choice.hull, choice.closer);
  const double more = choice.isWithin ? 0 : range.most - range.least;
  bound.least = std::max(range.least - more, 0.0);
  bound.most = range.most + more;
  bound.alone = std::move(choice.isCloser ? choice.closer : choice.values);
  bound.nodes = std::move(choice.nodes);
  bound.atNodes = std::move(choice.atNodes);
  return bound;
}

bool isCoupled(const std::vector<PressureBound>& fields) {
  return std::any_of(
             fields.begin(), fields.end(),
             [](const PressureBound& f) { return f.isSmooth && !f.isConstant; }) &&
         std::all_of(fields.begin(), fields.end(),
                     [](const PressureBound& f) { return f.isSmooth || f.isConstant; });
}

}  // namespace epafi::contact
