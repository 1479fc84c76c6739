#pragma once

#include "bem/base/Matrix.hpp"

#include <memory>

namespace epafi::contact {

using bem::at;
using bem::Index;
using bem::Matrix;
using bem::Vector;

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
  };

  /// Of size zero.
  Flexibility() : Flexibility(Matrix()) {}
  /// The dense form, by the full matrix.
  Flexibility(Matrix entries);  // NOLINT(google-explicit-constructor): the usual form
  explicit Flexibility(std::shared_ptr<const Operator> form);

  Index size() const { return operator_->size(); }
  Operator::Product product(const Vector& x) const { return operator_->product(x); }
  Vector times(const Vector& x) const { return operator_->times(x); }

  /// \pre D is formed.
  const Matrix& entries() const { return *entries_; }
  const double* column(Index j) const { return entries_->column(j); }
  double operator()(Index i, Index j) const { return (*entries_)(i, j); }

 private:
  std::shared_ptr<const Operator> operator_;
  const Matrix* entries_ = nullptr;
};

}  // namespace epafi::contact
