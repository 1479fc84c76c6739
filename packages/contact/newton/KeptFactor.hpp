#pragma once

#include "bem/algebra/LuFactor.hpp"
#include "contact/problem/Flexibility.hpp"

namespace epafi::contact {

class FactorMemory;

/// Factor of a linear system in D, Ĝ and K̂, by the factor of an earlier system that
/// differs in few rows, as Newton's systems of a path do when few coefficients change
/// their state.
///
///   z = z₀ + Y (C Y)⁻¹ (b - C z₀),   z₀: the solution of the earlier system,
///
/// C: the rows that differ, Y: the columns of the earlier inverse for them (Woodbury's
/// formula). Solutions need iterative refinement, which may not converge.
class KeptFactor final : public Flexibility::Operator::Factor {
 public:
  using System = Flexibility::Operator::System;

  /// Uses the factor in `memory` if it has the same D, Ĝ, K̂ and L and at most 15 % of
  /// the rows differ; else computes a new one and stores it there.
  /// \pre D is formed  \throws bem::NumericalError if the system is singular
  static std::unique_ptr<const Factor> make(const Flexibility& flexibility,
                                            const System& system, FactorMemory& memory);

  Matrix solve(Matrix b) const override;

 private:
  friend class FactorMemory;
  class Base;
  struct Row;

  KeptFactor(const std::shared_ptr<Base>& base, const std::vector<Row>& rows,
             const std::vector<Index>& changed);
  static std::vector<Row> rowsOf(const System& system, Index size);

  std::shared_ptr<const Base> base_;
  std::vector<Index> changed_;
  Vector rowScale_;       ///< factors of the rows of C
  Matrix rows_;           ///< Cᵀ
  Matrix responses_;      ///< Y
  bem::LuFactor factor_;  ///< of C Y
};

/// Factor shared by a sequence of solves with one D, on one thread.  The owner of the
/// sequence passes it to each solve.  Results depend on it up to rounding; start with a
/// new one to exclude that.
class FactorMemory {
 private:
  friend class KeptFactor;
  std::shared_ptr<KeptFactor::Base> base_;
};

}  // namespace epafi::contact
