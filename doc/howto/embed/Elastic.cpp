#include "Elastic.hpp"

#include "bem/tpetra/SteklovPoincareOperator.hpp"
#include "contact/body/Loads.hpp"

#include <BelosLinearProblem.hpp>
#include <BelosPseudoBlockCGSolMgr.hpp>
#include <BelosTpetraAdapter.hpp>
#include <Tpetra_MultiVector.hpp>
#include <Tpetra_Operator.hpp>

namespace embed {

namespace bem = epafi::bem;
namespace contact = epafi::contact;
using Teuchos::RCP;
using Teuchos::rcp;
using Map = Tpetra::Map<>;
using MultiVector = Tpetra::MultiVector<>;
using Operator = Tpetra::Operator<>;

namespace {

/// u -> S u + C Cᵀ u.  S alone lets the block move rigidly; the columns of C hold the
/// integrals of u over the boundary.
class HeldBlock final : public Operator {
 public:
  HeldBlock(RCP<const Operator> s, RCP<const MultiVector> functionals)
      : s_(std::move(s)),
        functionals_(std::move(functionals)),
        three_(rcp(new Map(functionals_->getNumVectors(), 0,
                           s_->getDomainMap()->getComm(), Tpetra::LocallyReplicated))) {}

  RCP<const Map> getDomainMap() const override { return s_->getDomainMap(); }
  RCP<const Map> getRangeMap() const override { return s_->getRangeMap(); }

  void apply(const MultiVector& x, MultiVector& y, Teuchos::ETransp, double alpha,
             double beta) const override {
    s_->apply(x, y, Teuchos::NO_TRANS, alpha, beta);
    MultiVector means(three_, x.getNumVectors());
    means.multiply(Teuchos::TRANS, Teuchos::NO_TRANS, 1, *functionals_, x, 0);
    y.multiply(Teuchos::NO_TRANS, Teuchos::NO_TRANS, alpha, *functionals_, means, 1);
  }

 private:
  RCP<const Operator> s_;
  RCP<const MultiVector> functionals_;
  RCP<const Map> three_;
};

// This process's rows of a replicated matrix or vector.
template <class Column>
RCP<MultiVector> distributed(const RCP<const Map>& map, std::size_t columns,
                             const Column& column) {
  const auto result = rcp(new MultiVector(map, columns));
  for (std::size_t j = 0; j < columns; ++j) {
    const double* values = column(j);
    for (std::size_t i = 0; i < map->getNodeNumElements(); ++i)
      result->replaceLocalValue(i, j, values[map->getGlobalElement(i)]);
  }
  return result;
}

}  // namespace

Elastic solveElastic(const Block& block, const bem::MpiProcesses& processes) {
  const RCP<const Operator> s =
      rcp(new bem::SteklovPoincareOperator(block.stiffness, processes));
  const contact::RigidModes modes = contact::makeRigidModes(block.space);
  const RCP<const MultiVector> functionals =
      distributed(s->getDomainMap(), 3, [&](std::size_t j) {
        return modes.functionals.column(static_cast<bem::Index>(j));
      });
  const contact::Loads loads = contact::makeLoads(block.space, pulled(), block.units);
  const RCP<const MultiVector> f =
      distributed(s->getRangeMap(), 1, [&](std::size_t) { return loads.load.data(); });
  const auto u = rcp(new MultiVector(s->getDomainMap(), 1));

  using Linear = Belos::LinearProblem<double, MultiVector, Operator>;
  const auto problem = rcp(new Linear(rcp(new HeldBlock(s, functionals)), u, f));
  problem->setProblem();
  const auto list = Teuchos::parameterList();
  list->set("Convergence Tolerance", 1e-12);
  list->set("Maximum Iterations", 1000);
  Belos::PseudoBlockCGSolMgr<double, MultiVector, Operator> solver(problem, list);
  if (solver.solve() != Belos::Converged)
    throw std::runtime_error("Belos has not converged");

  // Inside, lengths are in diameters and stresses in Young's moduli.
  const double unit = block.units.stress * block.units.length * block.units.length;
  Teuchos::Array<double> work(1);
  f->dot(*u, work());
  const double nu = block.material.poissonsRatio;
  return {0.5 * unit * work[0], 0.5 * (1 - nu * nu) / block.material.youngsModulus,
          solver.getNumIters()};
}

}  // namespace embed
