#include "bem/tpetra/BelosSolver.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/Error.hpp"
#include "bem/tpetra/SymmetricOperator.hpp"

#include <BelosLinearProblem.hpp>
#include <BelosPseudoBlockCGSolMgr.hpp>
#include <BelosTpetraAdapter.hpp>

#include <algorithm>

namespace epafi::bem {

namespace {

using Teuchos::RCP;
using Teuchos::rcp;
using Operator = Tpetra::Operator<>;
using MultiVector = Tpetra::MultiVector<>;

/// The inverses of the processes' own diagonal blocks.
class OwnBlocks final : public Operator {
 public:
  OwnBlocks(const SymmetricOperator& matrix, const TpetraAlgebra& algebra)
      : map_(matrix.getDomainMap()) {
    const Rows mine = algebra.myRows(matrix.rows().columns());
    factor_ = Matrix(mine.size(), mine.size());
    for (Index j = 0; j < mine.size(); ++j)
      std::copy_n(matrix.rows().column(mine.begin + j), mine.size(), factor_.column(j));
    const int info = cholesky(factor_);
    if (info != 0)
      throw NumericalError(
          message("the single layer potential V is not positive definite in row ",
                  mine.begin + info));
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
    choleskySolve(factor_, out.data(), static_cast<Index>(out.extent(1)),
                  static_cast<Index>(out.stride(1)));
  }

 private:
  RCP<const Tpetra::Map<>> map_;
  Matrix factor_;
};

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
  const auto matrix = rcp(new SymmetricOperator(lower, algebra_));
  lower = Matrix();
  const auto blocks = rcp(new OwnBlocks(*matrix, algebra_));
  Matrix result(right.rows(), right.columns());
  for (Index first = 0; first < right.columns(); first += options_.blockSize) {
    const Index count = std::min<Index>(options_.blockSize, right.columns() - first);
    const auto x =
        rcp(new MultiVector(matrix->getDomainMap(), static_cast<std::size_t>(count)));
    const auto b =
        rcp(new MultiVector(matrix->getDomainMap(), static_cast<std::size_t>(count)));
    {
      const auto view = b->getLocalViewHost(Tpetra::Access::OverwriteAll);
      for (Index j = 0; j < count; ++j)
        for (Index i = 0; i < right.rows(); ++i)
          view(i, j) = right(i, first + j);
    }
    algebra_.consent().confirm();
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
    const auto view = x->getLocalViewHost(Tpetra::Access::ReadOnly);
    for (Index j = 0; j < count; ++j)
      for (Index i = 0; i < right.rows(); ++i)
        result(i, first + j) = view(i, j);
  }
  return result;
}

}  // namespace epafi::bem
