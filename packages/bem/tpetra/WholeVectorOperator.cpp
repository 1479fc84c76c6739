#include "bem/tpetra/WholeVectorOperator.hpp"

#include <stdexcept>
#include <utility>

namespace epafi::bem {

WholeVectorOperator::WholeVectorOperator(Index n, Action action,
                                         const MpiProcesses& processes)
    : action_(std::move(action)),
      map_(processes.rowMap(n)),
      replicated_(processes.replicatedMap(n)),
      import_(map_, replicated_) {}

void WholeVectorOperator::apply(const MultiVector& x, MultiVector& y,
                                Teuchos::ETransp mode, double alpha, double beta) const {
  if (mode != Teuchos::NO_TRANS)
    throw std::logic_error("an operator on whole vectors does not know its transpose");
  const Matrix image = action_(whole(x));
  const auto out = y.getLocalViewHost(Tpetra::Access::ReadWrite);
  for (Index j = 0; j < image.columns(); ++j)
    for (int i = 0; i < static_cast<int>(out.extent(0)); ++i)
      out(i, j) = alpha * image(map_->getGlobalElement(i), j) +
                  (beta == 0 ? 0 : beta * out(i, j));
}

Matrix WholeVectorOperator::whole(const MultiVector& x) const {
  MultiVector all(replicated_, x.getNumVectors());
  all.doImport(x, import_, Tpetra::INSERT);
  const auto in = all.getLocalViewHost(Tpetra::Access::ReadOnly);
  Matrix columns(static_cast<Index>(in.extent(0)), static_cast<Index>(in.extent(1)));
  for (Index j = 0; j < columns.columns(); ++j)
    for (Index i = 0; i < columns.rows(); ++i)
      columns(i, j) = in(i, j);
  return columns;
}

}  // namespace epafi::bem
