#pragma once

#include "contact/newton/Reduction.hpp"

#include <memory>

namespace epafi::contact {

/// The linear system of a Newton step has no solution that could be trusted.
struct SingularJacobian : bem::NumericalError {
  using bem::NumericalError::NumericalError;
};

/// A way of solving a reduced system: some factor of it.
class Factoring {
 public:
  virtual ~Factoring() = default;

  /// d, then α, of J d = b, as well as the factor can.
  virtual Vector solve(const Vector& b) const = 0;
};

}  // namespace epafi::contact
