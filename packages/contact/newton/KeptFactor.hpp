#pragma once

#include "contact/problem/Problem.hpp"

namespace epafi::contact {

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

  /// By the factor that the problem's D keeps, or by a new one, which it keeps from now on.
  /// Null if it keeps none or if the system is near to singular.
  /// \pre motions, Ĝ, are those of all systems in this D.
  static std::unique_ptr<const KeptFactor> make(const Problem& problem,
                                                const Matrix& motions,
                                                std::vector<Row> rows);

  /// d, then α.
  Vector solve(const Vector& b) const;

 private:
  class Base;
  struct Slot;

  KeptFactor(std::shared_ptr<Base> base, const std::vector<Row>& rows,
             const std::vector<Index>& changed);

  std::shared_ptr<const Base> base_;
  std::vector<Index> changed_;
  Vector rowScale_;   ///< of C
  Matrix rows_;       ///< Cᵀ
  Matrix responses_;  ///< Y
  Matrix factor_;     ///< C Y as LU
  std::vector<int> pivots_;
};

}  // namespace epafi::contact
