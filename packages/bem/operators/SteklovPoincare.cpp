#include "bem/operators/SteklovPoincare.hpp"

#include "bem/base/Error.hpp"

#include <mutex>

namespace epafi::bem {

struct SteklovPoincare::Tractions {
  explicit Tractions(TractionKernels given)
      : elements(given.elements), kernels(std::move(given)) {}

  std::vector<int> elements;
  std::once_flag made;
  TractionKernels kernels;  ///< until they are made into rows
  std::shared_ptr<const TractionRows> rows;
};

SteklovPoincare::SteklovPoincare(Operators operators, const DenseAlgebra& algebra)
    : algebra_(&algebra),
      densities_(operators.singleLayer.columns()),
      tractions_(std::make_unique<Tractions>(std::move(operators.tractions))) {
  factor_ =
      algebra.cholesky(std::move(operators.singleLayer), "the single layer potential V");
  half_ = factor_->forward(std::move(operators.doubleLayer));
  const Rows mine = algebra.myRows(operators.hypersingular.columns());
  stiffness_ =
      LowerTriangle(algebra.addGram(std::move(operators.hypersingular), half_), mine);
}

SteklovPoincare::SteklovPoincare(Operators operators, const DenseAlgebra& algebra,
                                 const SingleLayerSolver& solver)
    : algebra_(&algebra),
      densities_(operators.singleLayer.columns()),
      half_(solver.solve(std::move(operators.singleLayer), operators.doubleLayer)),
      stiffness_(algebra.addTransposeTimes(std::move(operators.hypersingular),
                                           operators.doubleLayer, half_),
                 algebra.myRows(operators.doubleLayer.columns())),
      tractions_(std::make_unique<Tractions>(std::move(operators.tractions))) {}

SteklovPoincare::SteklovPoincare(SteklovPoincare&&) noexcept = default;
SteklovPoincare::~SteklovPoincare() = default;

const std::vector<int>& SteklovPoincare::tractionElements() const {
  return tractions_->elements;
}

// S φ = W φ + (K' + 1/2) V⁻¹ (K + 1/2) φ, transposed
std::shared_ptr<const TractionRows> SteklovPoincare::tractions() const {
  Tractions& tractions = *tractions_;
  std::call_once(tractions.made, [&] {
    if (tractions.kernels.start.empty())
      throw NumericalError("the tractions could not be formed before");
    TractionKernels kernels = std::move(tractions.kernels);
    tractions.kernels.start.clear();
    tractions.rows = std::make_shared<const TractionRows>(TractionRows{
        addAdjointDensity(std::move(kernels.hypersingular), std::move(kernels.adjoint)),
        std::move(kernels.start)});
  });
  return tractions.rows;
}

Vector SteklovPoincare::apply(const Vector& u) const {
  return algebra_->sum(stiffness_.times(u));
}

Vector SteklovPoincare::density(const Vector& u) const {
  Vector psi = algebra_->multiply(half_, densities_, u);
  return factor_ == nullptr ? psi : factor_->backward(psi);
}

Matrix SteklovPoincare::addAdjointDensity(Matrix c, Matrix b) const {
  if (factor_ != nullptr)
    b = factor_->forward(std::move(b));
  return algebra_->addTransposeTimes(std::move(c), half_, b);
}

}  // namespace epafi::bem
