#pragma once

#include "bem/operators/SteklovPoincare.hpp"
#include "bem/tpetra/WholeVectorOperator.hpp"

#include <algorithm>
#include <cassert>

namespace epafi::bem {

/// S as a Tpetra::Operator: maps displacements to nodal forces, the integrals of the traction
/// times the basis functions; dimensionless.
class SteklovPoincareOperator final : public WholeVectorOperator {
 public:
  /// Collective.  Refers to the operators.  \pre S is formed
  SteklovPoincareOperator(const SteklovPoincare& operators, const MpiProcesses& processes)
      : WholeVectorOperator(
            operators.stiffness().size(),
            [&operators](const Matrix& x) {
              Matrix forces(x.rows(), x.columns());
              for (Index j = 0; j < x.columns(); ++j) {
                const Vector f = operators.apply({x.column(j), x.column(j) + x.rows()});
                std::copy(f.begin(), f.end(), forces.column(j));
              }
              return forces;
            },
            processes) {
    assert(operators.compressed() == nullptr);
  }
};

}  // namespace epafi::bem
