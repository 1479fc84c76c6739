#pragma once

#include "contact/newton/Reduction.hpp"

#include <memory>

namespace epafi::contact {

class FactorMemory;

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

/// By D's entries in the inactive rows,
///
///   D_II,   bordered by the held rigid motions Ĝ:
///
/// symmetric positive definite on {Ĝᵀ d = 0} as long as no slip bound follows an unknown
/// pressure.  Cholesky then, with the border by its Schur complement; else LU of the same size.
/// Solutions have an error of rounding that one refinement takes away.
///
/// Refers to the reduction.  \throws SingularJacobian
std::unique_ptr<const Factoring> denseFactoring(const Reduction& reduction);

/// By the factor in a memory, brought up to date.  Solutions want refinement, and may not
/// converge.
///
/// Refers to the reduction.  Null where motions are not held, and where the memory's factor and a
/// new one are of no use.  \pre D is formed.
std::unique_ptr<const Factoring> keptFactoring(const Reduction& reduction,
                                               FactorMemory& memory);

/// By D's operator, which solves with D_II and lets coefficients at their bounds follow theirs;
/// held motions by the Schur complement of their responses.  Solutions are refined there.
///
/// Refers to the reduction.  \pre D is not formed.
/// \throws SingularJacobian
std::unique_ptr<const Factoring> operatorFactoring(const Reduction& reduction);

}  // namespace epafi::contact
