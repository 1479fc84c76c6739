#pragma once

#include "contact/newton/Factoring.hpp"

namespace epafi::contact {

/// By D's entries in the inactive rows,
///
///   D_II + diag(shift) ,   bordered by the held rigid motions Ĝ:
///
/// symmetric positive definite on {Ĝᵀ d = 0} as long as no slip bound follows an unknown
/// pressure.  Cholesky then, with the border by its Schur complement; else LU of the same size.
/// Solutions have an error of rounding that one refinement takes away.
///
/// Refers to the reduction.  \throws SingularJacobian
std::unique_ptr<const Factoring> denseFactoring(const Reduction& reduction);

}  // namespace epafi::contact
