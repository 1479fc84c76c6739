#include "bem/assembly/SteklovPoincare.hpp"

namespace epafi::bem {

SteklovPoincare::SteklovPoincare(Operators operators, const DenseAlgebra& algebra)
    : algebra_(&algebra),
      tractions_(std::move(operators.tractions)),
      densities_(operators.singleLayer.columns()) {
  factor_ =
      algebra.cholesky(std::move(operators.singleLayer), "the single layer potential V");
  half_ = factor_->forward(std::move(operators.doubleLayer));
  stiffness_ = algebra.addGram(std::move(operators.hypersingular), half_);
}

Vector SteklovPoincare::apply(const Vector& u) const {
  return algebra_->multiplySymmetric(stiffness_, u);
}

Vector SteklovPoincare::density(const Vector& u) const {
  return factor_->backward(algebra_->multiply(half_, densities_, u));
}

}  // namespace epafi::bem
