#pragma once

#include "bem/kernel/Elasticity.hpp"
#include "bem/moments/LegendreMoments.hpp"

namespace epafi::bem {

/// The sums of P_0 ... P_{terms-1} on an element at a target, in closed form.
///                                                         [doc/theory/operators.md]
class ElementSums {
 public:
  /// `need`: of the moments of a segment, CandD or All.
  void evaluate(const Curve& curve, const RelativeTarget& target, int terms,
                Need need = Need::CandD);

  SourceSums operator[](int j) const { return isStraight_ ? ofSegment(j) : ofArc_[j]; }

  /// Of a segment.
  const LegendreMoments& moments() const { return moments_; }

 private:
  SourceSums ofSegment(int j) const;
  void evaluateArc(const Curve& curve, const RelativeTarget& target, int terms);

  bool isStraight_ = true;
  Complex tangent_;
  double b_ = 0;
  LegendreMoments moments_;
  std::array<SourceSums, largestDegree + 2> ofArc_{};
};

}  // namespace epafi::bem
