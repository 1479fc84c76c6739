#pragma once

#include "bem/base/Material.hpp"
#include "bem/base/Matrix.hpp"
#include "bem/space/Space.hpp"

#include <vector>

namespace epafi::bem {

enum class TractionForm {
  Projected,  ///< L² projection to degree p                               [P (42)]
  Exact       ///< further columns, error 1e-12 of the quadratic form      [P sec. 6]
};

/// <W φ, P̂_i e_a>_E and <(K' + 1/2) ψ, P̂_i e_a>_E on some elements E, P̂_i the orthonormal
/// Legendre polynomials on E.  Rows: functions φ or ψ; column start[k] + 2 i + a belongs to the
/// k-th element.  In the exact form further columns follow, up to start[k+1]: coefficients of
/// tractions due to near elements in an orthonormal basis of the complement.
struct KernelRows {
  std::vector<Index> start;
  Matrix hypersingular;  ///< displacements x columns
  Matrix adjoint;        ///< densities x columns
};

/// Computes KernelRows: near sources in closed form, at points graded or softened toward the ends
/// of E and of the sources, where tractions have logarithms; far sources by FarBlocks.
/// Threads: over the elements.
/// \param moments for each element the number of P̂_i; the exact form adds more for far sources
/// \param further number of zero columns appended
/// \throws InputError if an element has more densities than its degree
KernelRows kernelRows(const Space& space, const Lame& lame,
                      const std::vector<int>& elements, const std::vector<int>& moments,
                      TractionForm form, Index further = 0);

}  // namespace epafi::bem
