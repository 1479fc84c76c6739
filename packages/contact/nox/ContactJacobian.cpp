#include "contact/nox/ContactJacobian.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/equation/Equilibrium.hpp"
#include "contact/newton/RigidPlacement.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <Thyra_DetachedSpmdVectorView.hpp>
#include <Thyra_LinearOpSourceBase.hpp>
#include <Thyra_MultiVectorBase.hpp>
#include <Thyra_MultiVectorStdOps.hpp>

#include <stdexcept>

namespace epafi::contact {

using bem::times;

Vector gathered(const SpmdSpace& space, const Thyra::VectorBase<double>& x) {
  const auto comm = space.getComm();
  const bool whole =
      comm.is_null() || comm->getSize() == 1 || space.isLocallyReplicated();
  const std::size_t begin = whole ? 0 : space.localOffset();
  Vector mine(space.dim(), 0.0);
  {
    const Thyra::ConstDetachedSpmdVectorView<double> view(Teuchos::rcpFromRef(x));
    for (Teuchos::Ordinal i = 0; i < view.subDim(); ++i)
      mine[begin + static_cast<std::size_t>(i)] = view[i];
  }
  if (whole)
    return mine;
  // One process contributes each entry, the others zero: exact, and equal on all.
  Vector all(mine.size());
  Teuchos::reduceAll(*comm, Teuchos::REDUCE_SUM,
                     static_cast<Teuchos::Ordinal>(mine.size()), mine.data(), all.data());
  return all;
}

void scatter(const SpmdSpace& space, const Vector& values, double scale, double shift,
             Thyra::VectorBase<double>& x) {
  const auto begin =
      static_cast<std::size_t>(space.isLocallyReplicated() ? 0 : space.localOffset());
  const Thyra::DetachedSpmdVectorView<double> view(Teuchos::rcpFromRef(x));
  for (Teuchos::Ordinal i = 0; i < view.subDim(); ++i) {
    const double value = scale * values[begin + static_cast<std::size_t>(i)];
    view[i] = shift == 0 ? value : value + shift * view[i];
  }
}

const NewtonSystem& Linearisation::system() const {
  if (system_ == nullptr)
    system_ = std::make_unique<NewtonSystem>(*equation_, evaluation_);
  return *system_;
}

const Linearisation& ContactJacobian::at() const {
  if (at_ == nullptr)
    throw std::logic_error("the contact Jacobian is used before it was evaluated");
  return *at_;
}

void ContactJacobian::applyImpl(Thyra::EOpTransp transpose, const MultiVector& x,
                                const Teuchos::Ptr<MultiVector>& y, double alpha,
                                double beta) const {
  const bool forward = Thyra::real_trans(transpose) == Thyra::NOTRANS;
  for (Teuchos::Ordinal j = 0; j < x.domain()->dim(); ++j) {
    const Vector v = gathered(*space_, *x.col(j));
    const Equation& equation = at().equation();
    const Evaluation& rows = at().evaluation();
    const Vector product =
        forward ? equation.jacobianTimes(rows, v) : equation.transposeTimes(rows, v);
    scatter(*space_, product, alpha, beta, *y->col(j));
  }
}

Vector ContactJacobian::solved(const Vector& b) const {
  const NewtonSystem& system = at().system();
  const Vector right = times(-1, b);
  const Evaluation& e = at().evaluation();
  bool isResidual = true;
  for (std::size_t i = 0; i < b.size(); ++i)
    isResidual = isResidual && b[i] == scale_ * e.residual[i];
  Vector motion = system.unheld(right);
  if (motion.empty()) {
    Vector x = system.solve(b);
    if (isResidual && overshoots(at().equation(), e, times(-1 / scale_, x)))
      motion = system.unpressed(right);
    if (motion.empty())
      return x;
  }
  if (!isResidual)
    throw NoBalance(
        "neither contact nor friction holds a rigid motion that the right-hand side "
        "demands: begin nearer to the solution");
  return times(-scale_, placingStep(at().equation(), e, motion));
}

Thyra::SolveStatus<double> ContactJacobian::solveImpl(
    Thyra::EOpTransp, const MultiVector& b, const Teuchos::Ptr<MultiVector>& x,
    const Teuchos::Ptr<const Thyra::SolveCriteria<double>>) const {
  Thyra::SolveStatus<double> status;
  status.solveStatus = Thyra::SOLVE_STATUS_CONVERGED;
  status.achievedTol = status.unknownTolerance();
  try {
    for (Teuchos::Ordinal j = 0; j < b.domain()->dim(); ++j)
      scatter(*space_, solved(gathered(*space_, *b.col(j))), 1, 0, *x->col(j));
  } catch (const bem::NumericalError& error) {
    if (failure_ == SolveFailure::Thrown)
      throw;
    Thyra::assign(x, 0.0);
    status.solveStatus = Thyra::SOLVE_STATUS_UNCONVERGED;
    status.message = error.what();
  }
  return status;
}

bool ContactJacobianFactory::isCompatible(
    const Thyra::LinearOpSourceBase<double>& source) const {
  return dynamic_cast<const ContactJacobian*>(source.getOp().get()) != nullptr;
}

void ContactJacobianFactory::initializeOp(
    const Teuchos::RCP<const Thyra::LinearOpSourceBase<double>>& source,
    Thyra::LinearOpWithSolveBase<double>* op, Thyra::ESupportSolveUse) const {
  Teuchos::dyn_cast<ContactJacobian>(*op).share(
      Teuchos::dyn_cast<const ContactJacobian>(*source->getOp()));
}

}  // namespace epafi::contact
