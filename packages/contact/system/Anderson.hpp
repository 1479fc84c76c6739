#pragma once

#include "bem/base/Matrix.hpp"

#include <cstddef>
#include <vector>

namespace epafi::contact {

/// Anderson's acceleration of a fixed-point iteration x -> x + f(x): among the combinations of the
/// last points, the one where f would be smallest if it were affine.  A map that is affine in fewer
/// variables than points are kept settles with as many as it has variables, also where plain steps
/// would jump to and fro.
class Anderson {
 public:
  explicit Anderson(std::size_t kept) : kept_(kept) {}

  /// What to add to x, where f is `change`; the change itself at first.
  bem::Vector stepBy(bem::Vector change);

 private:
  struct Difference {
    bem::Vector change;  ///< of f from one point to the next
    bem::Vector step;    ///< from one to the other
  };

  std::size_t kept_;
  std::vector<Difference> differences_{};  ///< the oldest one first
  bem::Vector change_{};
  bem::Vector step_{};
};

}  // namespace epafi::contact
