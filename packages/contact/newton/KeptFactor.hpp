#pragma once

#include "bem/algebra/LuFactor.hpp"
#include "contact/problem/Flexibility.hpp"

namespace epafi::contact {

class FactorMemory;

/// The factor of one linear system in D, Ĝ and K̂, kept for others that differ from it in few
/// rows: Newton's in a step of a path, in which few coefficients open, close, stick or slip.
///
/// With Y the responses of the kept system to the rows that differ, C what these rows say now:
/// z = z₀ + Y (C Y)⁻¹ (b - C z₀), z₀ the kept system's solution (Woodbury's formula).
///
/// Solutions want refinement, and may not converge.
class KeptFactor final : public Flexibility::Operator::Factor {
 public:
  using System = Flexibility::Operator::System;

  /// By the factor in a memory where it is of the same D, Ĝ and K̂ and few rows differ, else by a
  /// new one, which the memory has from now on.
  /// \pre D is formed.  \throws bem::NumericalError if the system is singular.
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
  Vector rowScale_;       ///< of C
  Matrix rows_;           ///< Cᵀ
  Matrix responses_;      ///< Y
  bem::LuFactor factor_;  ///< of C Y
};

/// The factor that a sequence of solves in one D goes on with, on one thread.  Whoever begins
/// the sequence has it and passes it on; a new sequence that shall not depend on what was solved
/// before begins with a new one.
class FactorMemory {
 private:
  friend class KeptFactor;
  std::shared_ptr<KeptFactor::Base> base_;
};

}  // namespace epafi::contact
