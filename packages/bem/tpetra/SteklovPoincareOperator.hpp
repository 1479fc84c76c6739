#pragma once

#include "bem/operators/SteklovPoincare.hpp"
#include "bem/tpetra/WholeVectorOperator.hpp"

#include <algorithm>

namespace epafi::bem {

/// S as a Tpetra::Operator: from displacements to the forces that belong to them,
/// dimensionless.
class SteklovPoincareOperator final : public WholeVectorOperator {
 public:
  /// Collective.  The operators, formed ones, outlive it.
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
            processes) {}
};

}  // namespace epafi::bem
