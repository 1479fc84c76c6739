#include "bem/kernel/ElementSums.hpp"

#include "bem/moments/ArcWeights.hpp"

namespace epafi::bem {

void ElementSums::evaluate(const Curve& curve, const RelativeTarget& target, int terms,
                           Need need) {
  isStraight_ = curve.isStraight();
  if (!isStraight_)
    return evaluateArc(curve, target, terms);
  tangent_ = asComplex(curve.segment().tangent);
  b_ = target.b();
  evaluateMoments(target, terms - 1, need, moments_);
}

// ∫ P_j ds/conj(w) = τ C_j,  ∫ P_j w/conj(w)² ds = τ³ (C_j - 2ib D_j)
SourceSums ElementSums::ofSegment(int j) const {
  const auto k = static_cast<std::size_t>(j);
  const Complex c = moments_.c[k];
  const Complex turned = tangent_ * c;
  // on the element's own line b = 0, and d need not exist
  const Complex cubic = b_ == 0 ? c : c - Complex(0, 2 * b_) * moments_.d[k];
  return {std::conj(turned), turned, tangent_ * tangent_ * tangent_ * cubic};
}

void ElementSums::evaluateArc(const Curve& curve, const RelativeTarget& target,
                              int terms) {
  const ArcRule rule(curve, terms - 1);
  ArcWeights weights;
  weights.evaluate(rule, target, ArcNeed::Sums);
  for (int j = 0; j < terms; ++j) {
    SourceSums sums;
    for (int q = 0; q < rule.size(); ++q) {
      const auto k = static_cast<std::size_t>(q);
      sums.overW += rule.legendre(q, j) * weights.overW[k];
      sums.cubic += rule.legendre(q, j) * weights.cubic[k];
    }
    sums.overW *= curve.half();
    sums.cubic *= curve.half();
    sums.overConj = std::conj(sums.overW);
    ofArc_[j] = sums;
  }
}

}  // namespace epafi::bem
