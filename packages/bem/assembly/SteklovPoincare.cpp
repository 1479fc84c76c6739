#include "bem/assembly/SteklovPoincare.hpp"

namespace epafi::bem {

SteklovPoincare::SteklovPoincare(Operators operators, const DenseAlgebra& algebra)
    : algebra_(&algebra),
      densities_(operators.singleLayer.columns()),
      tractions_(std::move(operators.tractions)) {
  factor_ =
      algebra.cholesky(std::move(operators.singleLayer), "the single layer potential V");
  half_ = factor_->forward(std::move(operators.doubleLayer));
  stiffness_ = algebra.addGram(std::move(operators.hypersingular), half_);
}

SteklovPoincare::SteklovPoincare(Operators operators, const DenseAlgebra& algebra,
                                 const SingleLayerSolver& solver)
    : algebra_(&algebra),
      densities_(operators.singleLayer.columns()),
      tractions_(std::move(operators.tractions)),
      half_(solver.solve(std::move(operators.singleLayer), operators.doubleLayer)),
      stiffness_(algebra.transposeTimes(operators.doubleLayer, half_)) {
  for (Index j = 0; j < stiffness_.columns(); ++j)
    for (Index i = 0; i < stiffness_.rows(); ++i)
      stiffness_(i, j) += operators.hypersingular(i, j);
}

Vector SteklovPoincare::apply(const Vector& u) const {
  return algebra_->multiplySymmetric(stiffness_, u);
}

Vector SteklovPoincare::density(const Vector& u) const {
  Vector psi = algebra_->multiply(half_, densities_, u);
  return factor_ == nullptr ? psi : factor_->backward(psi);
}

Matrix SteklovPoincare::adjointDensity(Matrix b) const {
  if (factor_ != nullptr)
    b = factor_->forward(std::move(b));
  return algebra_->transposeTimes(half_, b);
}

}  // namespace epafi::bem
