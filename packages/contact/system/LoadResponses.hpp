#pragma once

#include "bem/base/Matrix.hpp"

#include <functional>

namespace epafi::contact {

using bem::Vector;

/// What some loads of a body make of its offset d₀, which is linear in them.  A value that a path hands on
/// from each step that it keeps.
class LoadResponses {
 public:
  /// What a load makes: a combination of what is known, if the load is one of those to 1e-14 of
  /// its size and rounding grows by no more than a factor of 8 in it; else solve(), which is known
  /// from then on.
  Vector of(const Vector& load, const std::function<Vector()>& solve);

 private:
  struct Known {
    Vector load;
    Vector response;
  };
  std::vector<Known> known_;  ///< the newest first, the oldest last, another one between
};

}  // namespace epafi::contact
