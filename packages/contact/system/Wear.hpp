#pragma once

#include "contact/opposite/Obstacle.hpp"
#include "contact/system/SlipIteration.hpp"

namespace epafi::contact {

/// What slip has done to the contact sides of all bodies up to a step of a path, dimensionless values
/// at the p + 1 Gauss points of each element, see MultiplierSpace::throughPoints:
///
///   w = w⁻ + n k |Δs| λₙ,   Δs the step's slip, n how many times it happens.
///                                                              doc/theory/surfaces.md
struct Wear {
  Vector depth;     ///< w
  Vector distance;  ///< Σ n |Δs| of where sides are closed
  Vector slid;      ///< m, what slid by
  Vector rate;      ///< n k |Δs| of the step: by how much more a pressure wears
};

/// The wear of a step of a path.
class StepWear {
 public:
  /// `before`: behind the step before; empty: nothing wore.
  StepWear(std::shared_ptr<const Obstacle> obstacle, Wear before);

  /// Does anything wear?
  bool wears() const { return wears_; }
  /// <w, χ_i> of all coefficients; of the step before: empty where nothing wore.
  Vector tested(const Wear& wear) const;
  const Vector& testedBefore() const { return testedBefore_; }

  /// Lets the step wear by slips Δrₜ, one per coefficient (those of normal ones do not matter), empty:
  /// not known, by what slides by.  M_w = ∫ n k |Δs| χ_i χ_j takes its place at the end of L.  |Δs| is
  /// moved by a part of its change, see SlipIteration, which is returned.
  /// `response`: S' at the points, see there; of size zero: not known.
  double setSlips(const Vector& slip, Surface& surface, Matrix response = {});
  bool wantsResponse() const { return slips_.wantsResponse(); }
  /// By columns, one per point, ∂(M_w λ)/∂|Δs|; and what changes of |Δrₜ| do to |Δs| at the
  /// points.
  Matrix wornBy(const Vector& multiplier) const;
  Vector atPoints(const Vector& changes) const;
  /// |Δs| are next those of the slips, whatever they were.
  void forgetIterations() { slips_.forget(); }

  /// Behind the step.  `stress`: see Problem
  Wear behind(const Vector& multiplier, double stress) const;

 private:
  std::shared_ptr<const Obstacle> obstacle_;
  Wear before_;
  bool wears_ = false;
  Vector testedBefore_;
  SlipIteration slips_{};  ///< |Δs| at the points
  Vector rates_{};         ///< n k |Δs|
};

}  // namespace epafi::contact
