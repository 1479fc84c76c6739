#pragma once

#include "bem/algebra/LuFactor.hpp"
#include "contact/problem/Flexibility.hpp"

namespace epafi::contact {

class FactorMemory;

/// The factor of one linear system in D and G, kept for others that differ from it in few
/// rows: Newton's in a step of a path, in which few coefficients open, close, stick or slip.
///
/// A row says what a coefficient's change d_i is:
///
///   solved for   Σ_j D_ij d_j - Σ_j Ĝ_ij α_j = b_i        Ĝ: G with columns of size one
///   else         d_i - Σ factor d_leader = b_i,           leaders are solved for
///   balance      Σ_i Ĝ_ij d_i = b_j
///
/// With Y the responses of the kept system to the rows that differ, C what these rows say now:
/// z = z₀ + Y (C Y)⁻¹ (b - C z₀), z₀ the kept system's solution (Woodbury's formula).
class KeptFactor {
 public:
  struct Row {
    struct Share {
      Index leader;
      double factor;
      bool operator==(const Share& o) const {
        return leader == o.leader && factor == o.factor;
      }
    };
    bool isSolved = false;
    std::vector<Share> followed{};
    bool operator==(const Row& o) const {
      return isSolved == o.isSolved && followed == o.followed;
    }
  };

  /// By the factor in a memory where it is of the same D and Ĝ and few rows differ, else by a
  /// new one, which the memory has from now on.  Null, and nothing is kept, if the system is
  /// near to singular.
  static std::unique_ptr<const KeptFactor> make(const Flexibility& flexibility,
                                                const Matrix& motions,
                                                const std::vector<Row>& rows,
                                                FactorMemory& memory);

  /// d, then α.
  Vector solve(const Vector& b) const;

 private:
  friend class FactorMemory;
  class Base;

  KeptFactor(const std::shared_ptr<Base>& base, const std::vector<Row>& rows,
             const std::vector<Index>& changed);

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
