#pragma once

#include "contact/opposite/Obstacle.hpp"

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
  /// not known, by what slides by.  M_w = ∫ n k |Δs| χ_i χ_j takes its place at the end of L.  From
  /// the third time on |Δs| takes a share ω of its change, since slips may jump to and fro or
  /// settle slowly; by Aitken's rule for vectors, so that changes that are each a multiple of the one
  /// before, of either sign, vanish with the third.  (Of slips some stick and some do not: Anderson's
  /// steps settle fewer scenes.)  Returns ω.
  double setSlips(const Vector& slip, Surface& surface);
  /// |Δs| are next those of the slips, whatever they were.
  void forgetIterations() { known_ = false; }

  /// Behind the step.  `stress`: see Problem
  Wear behind(const Vector& multiplier, double stress) const;

 private:
  void takeSlips(const Vector& slip);
  /// ω of the change that the slips of a solution ask for after the last share.
  double shareOf(const Vector& change);

  std::shared_ptr<const Obstacle> obstacle_;
  Wear before_;
  bool wears_ = false;
  Vector testedBefore_;
  Vector slips_{};         ///< |Δs| at the points
  bool known_ = false;     ///< are slips_ those of a solution?
  Vector changeBefore_{};  ///< see shareOf; empty: none
  double share_ = 1;       ///< ω
  Vector rates_{};         ///< n k |Δs|
};

}  // namespace epafi::contact
