#pragma once

#include "bem/base/Error.hpp"
#include "bem/base/Matrix.hpp"

#include <cassert>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace epafi::contact {

using bem::at;
using bem::Index;
using bem::Matrix;
using bem::Vector;

/// The linear system of a Newton step is singular to working precision.
struct SingularJacobian : bem::NumericalError {
  using bem::NumericalError::NumericalError;
};

/// Compliance matrix D of a condensed contact problem: symmetric, positive semidefinite,
/// immutable.  Problems that differ in other data share it.
class Flexibility {
 public:
  /// Representation of D: dense, or an operator that computes products only.
  class Operator {
   public:
    virtual ~Operator() = default;
    virtual Index size() const = 0;
    /// D x and |D| |x|.  The latter measures rounding errors and may be an estimate.
    struct Product {
      Vector value;
      Vector magnitude;
    };
    virtual Product product(const Vector& x) const = 0;
    virtual Vector times(const Vector& x) const = 0;
    /// The entries of D; null if they are not formed.
    virtual const Matrix* entries() const { return nullptr; }
    /// A copy of the entries of D, computed if they are not formed; symmetric.
    virtual Matrix formed() const = 0;

    /// A linear system for the coefficients x and the amplitudes β of rigid motions Ĝ:
    ///
    ///   rows       Σ_j (D + L)_ij x_j - Σ_k Ĝ_ik β_k = b_i
    ///   others     x_i - Σ factor x_leader = b_i
    ///   balance    Σ_i Ĝ_ik x_i + Σ_l K̂_kl β_l = b_k
    struct System {
      std::vector<Index> rows;  ///< the coefficients with an equation in D
      std::vector<bem::Entry>
          followers;   ///< (i, leader, factor); leaders are among the rows
      Matrix motions;  ///< Ĝ, one row per coefficient; rows or springs fix each motion
      std::vector<bem::Entry> added{};  ///< L, local to elements
      Matrix stiffness{};               ///< K̂, of springs; empty: zero
    };
    class Factor {
     public:
      virtual ~Factor() = default;
      /// Solves for each column of b: first b_i of all coefficients, then b_k of the balances.
      /// Returns x, then β.  Without iterative refinement, which converges with this factor.
      virtual Matrix solve(Matrix b) const = 0;
    };
    /// Refers to D.  \throws bem::NumericalError if the system is singular.
    virtual std::unique_ptr<Factor> factor(System system) const = 0;
    /// Rigid motions are left as they are in systems if rows hold each combination of them at least to
    /// this fraction of the best held one; else they are combined to equal values.
    virtual double leastHeld() const { return 1e-3; }
    /// Frees data cached between systems.
    virtual void release() const {}
  };

  /// A matrix of size zero.
  Flexibility() : Flexibility(Matrix()) {}
  /// A dense matrix, which factors systems by Cholesky, leaders of followers and motions by LU.
  Flexibility(Matrix entries);  // NOLINT(google-explicit-constructor): the usual form
  explicit Flexibility(std::shared_ptr<const Operator> form);

  Index size() const { return operator_->size(); }
  Operator::Product product(const Vector& x) const { return operator_->product(x); }
  /// Row sums Σ_j |D_ij|, one per i, over j of the same kind (the first `normals`, or the
  /// others): a bound of the penetration under multipliers of this kind with |λ_j| <= 1.
  /// Estimates like Product::magnitude.  Cached for all problems that share D.
  const Vector& responses(Index normals) const;
  Vector times(const Vector& x) const { return operator_->times(x); }

  /// Are the entries of D stored?
  bool isFormed() const { return entries_ != nullptr; }
  std::unique_ptr<Operator::Factor> factor(Operator::System system) const {
    return operator_->factor(std::move(system));
  }
  double leastHeld() const { return operator_->leastHeld(); }
  void release() const { operator_->release(); }
  /// \pre isFormed()
  const Matrix& entries() const {
    assert(isFormed());
    return *entries_;
  }
  /// A copy of the entries of D; if they are not formed, by one product per column.
  Matrix formed() const { return operator_->formed(); }
  const double* column(Index j) const { return entries().column(j); }

  double operator()(Index i, Index j) const { return entries()(i, j); }

 private:
  /// Cache of responses().
  struct Found {
    std::mutex mutex;
    std::map<Index, Vector> responses;  ///< by `normals`
  };

  std::shared_ptr<const Operator> operator_;
  std::shared_ptr<Found> found_ = std::make_shared<Found>();
  const Matrix* entries_ = nullptr;
};

}  // namespace epafi::contact
