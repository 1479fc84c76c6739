#pragma once

#include "bem/base/Material.hpp"
#include "bem/base/Matrix.hpp"
#include "bem/space/Space.hpp"

#include <vector>

namespace epafi::bem {

enum class TractionForm {
  Projected,  ///< only the columns up to degree p                         [P (42)]
  Exact       ///< all that matters to 1e-12 of the quadratic form         [P sec. 6]
};

/// <W φ, P̂_i e_a>_E and <(K' + 1/2) ψ, P̂_i e_a>_E on some elements E, transposed: rows are the
/// functions φ and ψ, column start[k] + 2 i + a is the k-th element's.  P̂_i are the orthonormal
/// Legendre polynomials on E.  In the exact form further columns follow, up to start[k+1]: what
/// near sources have beyond these polynomials, in an orthonormal basis.
struct KernelRows {
  std::vector<Index> start;
  Matrix hypersingular;  ///< displacements x columns
  Matrix adjoint;        ///< densities x columns
};

/// Sources nearby in closed form at points that are graded or softened toward the ends of E and
/// of theirs, where tractions have logarithms; far ones by FarBlocks.  No difference quotients.
///
/// `moments`: of each element, i below it; the exact form has more of them if far sources need
/// them.  `further`: columns of zeros behind all.  Threads: over the elements.
/// \throws InputError for densities beyond the degree of their element.
KernelRows kernelRows(const Space& space, const Lame& lame,
                      const std::vector<int>& elements, const std::vector<int>& moments,
                      TractionForm form, Index further = 0);

}  // namespace epafi::bem
