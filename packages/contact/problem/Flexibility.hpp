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

/// The linear system of a Newton step has no solution that could be trusted.
struct SingularJacobian : bem::NumericalError {
  using bem::NumericalError::NumericalError;
};

/// The flexibility D of a condensed contact problem: symmetric, positive semidefinite,
/// never changed, and shared by all problems that differ in something else.
class Flexibility {
 public:
  /// What D does; another one than the dense matrix may know it without its entries.
  class Operator {
   public:
    virtual ~Operator() = default;
    virtual Index size() const = 0;
    /// D x and |D| |x|; of the latter, which rounding and steps are measured by, the size
    /// suffices.
    struct Product {
      Vector value;
      Vector magnitude;
    };
    virtual Product product(const Vector& x) const = 0;
    virtual Vector times(const Vector& x) const = 0;
    /// All of D; null where it is not formed.
    virtual const Matrix* entries() const { return nullptr; }
    /// All of D, symmetric, made for who asks.
    virtual Matrix formed() const = 0;

    /// A linear system for the coefficients x and the sizes β of rigid motions Ĝ:
    ///
    ///   rows       Σ_j (D + L)_ij x_j - Σ_k Ĝ_ik β_k = b_i
    ///   others     x_i - Σ factor x_leader = b_i
    ///   balance    Σ_i Ĝ_ik x_i + Σ_l K̂_kl β_l = b_k
    struct System {
      std::vector<Index> rows;            ///< the coefficients that are solved for
      std::vector<bem::Entry> followers;  ///< of others, with leaders among the rows
      Matrix motions;  ///< Ĝ, by all coefficients; the rows or springs hold each
      std::vector<bem::Entry> added{};  ///< L, by all coefficients, local to elements
      Matrix stiffness{};               ///< K̂, of springs; empty: there are none
    };
    class Factor {
     public:
      virtual ~Factor() = default;
      /// (x, β) of columns b, as well as the factor can: their error of rounding is one that
      /// refinement takes away.
      virtual Matrix solve(Matrix b) const = 0;
    };
    /// Refers to D.  \throws bem::NumericalError if the system is singular.
    virtual std::unique_ptr<Factor> factor(System system) const = 0;
    /// Frees what it keeps of a system for the next one.
    virtual void release() const {}
  };

  /// Of size zero.
  Flexibility() : Flexibility(Matrix()) {}
  /// The dense form, by the full matrix.
  Flexibility(Matrix entries);  // NOLINT(google-explicit-constructor): the usual form
  explicit Flexibility(std::shared_ptr<const Operator> form);

  Index size() const { return operator_->size(); }
  Operator::Product product(const Vector& x) const { return operator_->product(x); }
  /// Σ_j |D_ij| over the coefficients of i's own kind, the first `normals` or the others: the
  /// penetration that a uniform multiplier of size 1 makes.  Found once for all that share D.
  const Vector& responses(Index normals) const;
  Vector times(const Vector& x) const { return operator_->times(x); }

  /// Are the entries there?
  bool isFormed() const { return entries_ != nullptr; }
  std::unique_ptr<Operator::Factor> factor(Operator::System system) const {
    return operator_->factor(std::move(system));
  }
  void release() const { operator_->release(); }
  /// \pre isFormed()
  const Matrix& entries() const { return *entries_; }
  /// All of D, made where it is not there: as many products as it has columns.
  Matrix formed() const { return operator_->formed(); }
  const double* column(Index j) const { return entries().column(j); }

  double operator()(Index i, Index j) const { return entries()(i, j); }

 private:
  /// What is found from D once.
  struct Found {
    std::mutex mutex;
    std::map<Index, Vector> responses;  ///< by the number of normals
  };

  std::shared_ptr<const Operator> operator_;
  std::shared_ptr<Found> found_ = std::make_shared<Found>();
  const Matrix* entries_ = nullptr;
};

}  // namespace epafi::contact
