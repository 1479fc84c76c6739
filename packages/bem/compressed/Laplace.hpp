#pragma once

#include "bem/compressed/CompressedFactor.hpp"
#include "bem/compressed/CompressedOperators.hpp"
#include "bem/operators/RingLaplace.hpp"
#include "bem/space/Space.hpp"

#include <memory>
#include <vector>

namespace epafi::bem {

/// Interior mixed problem of Laplace: T given on some elements, q on the others.  With w = x - y
///
///   V q = -1/2π ∫ log|w| q ds,  K T = 1/2π ∫ (w·n_y)/|w|² T ds,  W T = -d/ds V (dT/ds),
///   V q = (1/2 + K) T,          W T = (1/2 - K') q,
///
/// the first equation is tested where T is given, the second where q is: these are the rows of
/// CompressedOperators without what is given, since given q and free T have no node in common.  On
/// a hole where only q is given, the second leaves a constant of T free: T is held in a node, and
/// the mean of the first over the hole gives the constant.  Around an axis of revolution it is RingLaplace.
/// Dimensionless, diameter of the outline at most 1.              [doc/theory/operators.md]
class MixedLaplace {
 public:
  /// Refers to the space.
  /// \param isPotentialGiven by element: is T given on it?
  /// \pre one component; T is given on an element
  MixedLaplace(const Space& space, const std::vector<bool>& isPotentialGiven,
               const Compression& options = {});

  /// Complete Cauchy data; entries of `data` that are not given are ignored.
  Vector solve(Vector data) const;

 private:
  /// The rows above, right sides minus left ones.
  Vector residual(const Vector& data) const;

  const Space& space_;
  std::unique_ptr<const RingLaplace>
      rings_;  ///< of solids of revolution, in place of the rest
  std::vector<FreeSurface> freeSurfaces_;
  std::vector<bool> isUnknown_;
  std::unique_ptr<const CompressedOperators> operators_;
  std::unique_ptr<const CompressedFactor> factor_;
};

}  // namespace epafi::bem
