#pragma once

#include "bem/algebra/SmallAlgebra.hpp"

#include <algorithm>
#include <utility>

namespace epafi::contact {

/// The share ω of its change that a fixed-point iteration takes, by Aitken's rule for vectors:
/// changes that are each a multiple of the one before, of either sign, vanish with the third.  For
/// slips that wear, of which some stick and some do not: Anderson's steps settle fewer such scenes.
class Aitken {
 public:
  /// Of the change that the map gives after the last share was taken; 1 for the first one.
  double shareOf(bem::Vector change) {
    if (!before_.empty()) {
      bem::Vector turned = before_;
      bem::axpy(-1, change, turned);
      const double square = bem::dot(turned, turned);
      share_ = square > 0
                   ? std::clamp(share_ * bem::dot(before_, turned) / square, least, most)
                   : 1;
    }
    before_ = std::move(change);
    return share_;
  }

 private:
  static constexpr double least = 0.125;
  static constexpr double most = 4;

  bem::Vector before_;
  double share_ = 1;
};

}  // namespace epafi::contact
