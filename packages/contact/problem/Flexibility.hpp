#pragma once

#include "bem/base/Error.hpp"
#include "bem/base/Matrix.hpp"

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
/// immutable, shared by problems with other data.
class Flexibility {
 public:
  /// Representation of D, dense or by products only.
  class Operator {
   public:
    virtual ~Operator() = default;
    virtual Index size() const = 0;
    /// D x and |D| |x|; the latter, a measure of rounding errors, may be an estimate.
    struct Product {
      Vector value;
      Vector magnitude;
    };
    virtual Product product(const Vector& x) const = 0;
    virtual Vector times(const Vector& x) const = 0;
    /// The matrix D; null if it is not formed.
    virtual const Matrix* entries() const { return nullptr; }
    /// A copy of D, computed if it is not formed; symmetric.
    virtual Matrix formed() const = 0;

    /// A linear system for the coefficients x and the amplitudes β of rigid motions Ĝ:
    ///
    ///   rows       Σ_j (D + L)_ij x_j - Σ_k Ĝ_ik β_k = b_i
    ///   others     x_i - Σ factor x_leader = b_i
    ///   balance    Σ_i Ĝ_ik x_i + Σ_l K̂_kl β_l = b_k
    struct System {
      std::vector<Index> rows;  ///< the coefficients that are solved for
      std::vector<bem::Entry>
          followers;   ///< (i, leader, factor); leaders are among the rows
      Matrix motions;  ///< Ĝ, one row per coefficient; the rows or springs constrain each
      std::vector<bem::Entry> added{};  ///< L, local to elements
      Matrix stiffness{};               ///< K̂, of springs; empty: zero
    };
    class Factor {
     public:
      virtual ~Factor() = default;
      /// (x, β) for columns b, b_i of rows and others in one numbering, then b_k.  Not
      /// refined; iterative refinement with this factor converges.
      virtual Matrix solve(Matrix b) const = 0;
    };
    /// Refers to D.  \throws bem::NumericalError if the system is singular.
    virtual std::unique_ptr<Factor> factor(System system) const = 0;
    /// Frees what is cached between systems.
    virtual void release() const {}
  };

  /// Size zero.
  Flexibility() : Flexibility(Matrix()) {}
  /// Dense.
  Flexibility(Matrix entries);  // NOLINT(google-explicit-constructor): the usual form
  explicit Flexibility(std::shared_ptr<const Operator> form);

  Index size() const { return operator_->size(); }
  Operator::Product product(const Vector& x) const { return operator_->product(x); }
  /// Row sums Σ_j |D_ij|, one per i, over j of the same kind (the first `normals`, or the
  /// others): the penetration under a uniform multiplier of size 1.  Cached for all that
  /// share D.
  const Vector& responses(Index normals) const;
  Vector times(const Vector& x) const { return operator_->times(x); }

  /// Is D stored as a matrix?
  bool isFormed() const { return entries_ != nullptr; }
  std::unique_ptr<Operator::Factor> factor(Operator::System system) const {
    return operator_->factor(std::move(system));
  }
  void release() const { operator_->release(); }
  /// \pre isFormed()
  const Matrix& entries() const { return *entries_; }
  /// A copy of D; if it is not formed, by one product per column.
  Matrix formed() const { return operator_->formed(); }
  const double* column(Index j) const { return entries().column(j); }

  double operator()(Index i, Index j) const { return entries()(i, j); }

 private:
  /// Cache.
  struct Found {
    std::mutex mutex;
    std::map<Index, Vector> responses;  ///< by `normals`
  };

  std::shared_ptr<const Operator> operator_;
  std::shared_ptr<Found> found_ = std::make_shared<Found>();
  const Matrix* entries_ = nullptr;
};

}  // namespace epafi::contact
