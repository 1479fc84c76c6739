#include "bem/tpetra/BelosSolver.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/Error.hpp"
#include "bem/tpetra/WholeVectorOperator.hpp"

#include <BelosLinearProblem.hpp>
#include <BelosPseudoBlockCGSolMgr.hpp>
#include <BelosTpetraAdapter.hpp>
#include <Teuchos_BLAS.hpp>

#include <algorithm>

namespace epafi::bem {

namespace {

using Teuchos::RCP;
using Teuchos::rcp;
using Operator = Tpetra::Operator<>;
using MultiVector = Tpetra::MultiVector<>;

/// The inverses of the diagonal blocks of the processes' own rows.
class OwnBlocks final : public Operator {
 public:
  OwnBlocks(const Matrix& lower, RCP<const Tpetra::Map<>> map) : map_(std::move(map)) {
    const auto size = static_cast<Index>(map_->getNodeNumElements());
    const Index first = size > 0 ? map_->getMinGlobalIndex() : 0;
    factor_ = Matrix(size, size);
    for (Index j = 0; j < size; ++j)
      std::copy_n(lower.column(first + j) + first + j, size - j, factor_.column(j) + j);
    const int info = cholesky(factor_);
    if (info != 0)
      throw NumericalError(message(
          "the single layer potential V is not positive definite in row ", first + info));
  }

  RCP<const Tpetra::Map<>> getDomainMap() const override { return map_; }
  RCP<const Tpetra::Map<>> getRangeMap() const override { return map_; }

  // Belos asks for y = M x only.
  void apply(const MultiVector& x, MultiVector& y, Teuchos::ETransp, double,
             double) const override {
    const auto in = x.getLocalViewHost(Tpetra::Access::ReadOnly);
    const auto out = y.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t j = 0; j < in.extent(1); ++j)
      for (std::size_t i = 0; i < in.extent(0); ++i)
        out(i, j) = in(i, j);
    choleskySolve(factor_, {out.data(), factor_.rows(), static_cast<Index>(out.extent(1)),
                            static_cast<Index>(out.stride(1))});
  }

 private:
  RCP<const Tpetra::Map<>> map_;
  Matrix factor_;
};

/// A X of a symmetric matrix.
Matrix symmetricProduct(const Matrix& lower, const Matrix& x) {
  Matrix y(x.rows(), x.columns());
  if (!x.empty())
    Teuchos::BLAS<int, double>().SYMM(Teuchos::LEFT_SIDE, Teuchos::LOWER_TRI,
                                      asInt(x.rows()), asInt(x.columns()), 1,
                                      lower.data(), asInt(lower.stride()), x.data(),
                                      asInt(x.stride()), 0, y.data(), asInt(y.stride()));
  return y;
}

RCP<Teuchos::ParameterList> listOf(const BelosOptions& options) {
  auto list = Teuchos::parameterList();
  list->set("Convergence Tolerance", options.tolerance);
  list->set("Maximum Iterations", options.maximumIterations);
  return list;
}

}  // namespace

Matrix BelosSolver::solve(Matrix lower, const Matrix& right) const {
  using Problem = Belos::LinearProblem<double, MultiVector, Operator>;
  using Manager = Belos::PseudoBlockCGSolMgr<double, MultiVector, Operator>;
  const auto matrix = rcp(new WholeVectorOperator(
      lower.rows(), [&](const Matrix& x) { return symmetricProduct(lower, x); },
      processes_));
  const auto map = matrix->getDomainMap();
  const auto blocks = rcp(new OwnBlocks(lower, map));
  Matrix result(right.rows(), right.columns());
  for (Index first = 0; first < right.columns(); first += options_.blockSize) {
    const Index count = std::min<Index>(options_.blockSize, right.columns() - first);
    const auto x = rcp(new MultiVector(map, at(count)));
    const auto b = rcp(new MultiVector(map, at(count)));
    {
      const auto view = b->getLocalViewHost(Tpetra::Access::OverwriteAll);
      for (Index j = 0; j < count; ++j)
        for (int i = 0; i < static_cast<int>(view.extent(0)); ++i)
          view(i, j) = right(map->getGlobalElement(i), first + j);
    }
    processes_.consent().confirm();
    const auto problem = rcp(new Problem(matrix, x, b));
    problem->setLeftPrec(blocks);
    problem->setProblem();
    Manager manager(problem, listOf(options_));
    Belos::ReturnType end = Belos::Unconverged;
    try {
      end = manager.solve();
    } catch (const Belos::BelosError& error) {  // the same on all ranks
      throw NumericalError("the single layer potential V: ", error.what());
    }
    if (end != Belos::Converged)
      throw NumericalError(
          "the single layer potential V: Belos does not reach the Tolerance ",
          options_.tolerance, " within ", manager.getNumIters(), " iterations");
    const Matrix solved = matrix->whole(*x);
    for (Index j = 0; j < count; ++j)
      std::copy_n(solved.column(j), solved.rows(), result.column(first + j));
  }
  return result;
}

}  // namespace epafi::bem
