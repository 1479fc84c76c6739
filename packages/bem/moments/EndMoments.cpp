#include "bem/moments/EndMoments.hpp"

#include "bem/moments/ArcWeights.hpp"
#include "bem/moments/RelativeTarget.hpp"

#include <cmath>

namespace epafi::bem {

namespace {

EndMoments endMomentsOfArc(const Element& source, const RelativeTarget& target) {
  const ArcRule rule(source.curve, source.degree);
  ArcWeights weights;
  weights.evaluate(rule, target, ArcNeed::Potentials);
  EndMoments result;
  for (int q = 0; q < rule.size(); ++q)
    for (int j = 0; j < source.degree; ++j) {
      result.log[j] += rule.legendre(q, j) * weights.log[q];
      result.phase[j] += rule.legendre(q, j) * weights.phase[q];
    }
  return result;
}

}  // namespace

EndMoments endMoments(const Mesh& mesh, int f, const BoundaryPoint& x) {
  const Element& source = mesh[f];
  const RelativeTarget target = seenFrom(mesh, f, x);
  if (!source.curve.isStraight())
    return endMomentsOfArc(source, target);
  const Complex tangent = asComplex(source.segment().tangent);
  const Complex square = tangent * tangent;
  const bool atStart = target.zPlus1 == 0.0;
  const bool atEnd = target.zMinus1 == 0.0;
  LegendreMoments m;
  if (!atStart && !atEnd)
    evaluateMoments(target, source.degree - 1, Need::CandL, m);
  EndMoments result;
  for (int j = 0; j < source.degree; ++j) {
    const double constant = j == 0 ? 2 : 0;
    double l = 0;
    Complex bc = 0;          // b C_j -> 0 at the ends
    if (atStart || atEnd) {  // limits of the closed form
      const double limit = j == 0 ? 2 * std::log(2.0) - 2 : -2.0 / (j * (j + 1.0));
      l = atStart && j % 2 == 1 ? -limit : limit;
    } else {
      l = m.l[j];
      bc = target.b() * m.c[j];
    }
    result.log[j] = l + constant * std::log(source.half);
    // w/conj(w) = τ² (z/conj(z) turned) = τ² (1 - 2ib/(z-t))
    result.phase[j] = square * (constant - Complex(0, 2) * bc);
  }
  return result;
}

}  // namespace epafi::bem
