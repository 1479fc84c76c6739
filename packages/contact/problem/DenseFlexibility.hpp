#pragma once

#include "contact/problem/Flexibility.hpp"

namespace epafi::contact {

/// D as a dense matrix.
class DenseFlexibility final : public Flexibility::Operator {
 public:
  explicit DenseFlexibility(Matrix entries);

  Index size() const override { return entries_.rows(); }
  Product product(const Vector& x) const override;
  Vector times(const Vector& x) const override;
  const Matrix* entries() const override { return &entries_; }
  Matrix formed() const override { return entries_.copy(); }

  /// Without followers and springs, D in the rows is symmetric positive definite on {Ĝᵀ x
  /// = 0}: Cholesky, with the border by its Schur complement.  Else LU with the border.
  /// \throws SingularJacobian
  std::unique_ptr<Factor> factor(System system) const override;

 private:
  template <class Add>
  void overColumns(const Vector& x, const Add& add) const;

  Matrix entries_;
};

}  // namespace epafi::contact
