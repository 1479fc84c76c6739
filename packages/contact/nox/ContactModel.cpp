#include "contact/nox/ContactModel.hpp"

#include "bem/base/Error.hpp"
#include "contact/nox/ContactJacobian.hpp"

#include <NOX_Abstract_Group.H>
#include <NOX_Thyra_Vector.H>
#include <Thyra_DefaultSpmdVectorSpace.hpp>
#include <Thyra_MultiVectorBase.hpp>
#include <Thyra_VectorStdOps.hpp>

#include <utility>

namespace epafi::contact {

using Teuchos::RCP;
using Base = Thyra::ModelEvaluatorBase;

namespace {

RCP<const SpmdSpace> spaceOf(const Problem& problem,
                             const ContactModel::Options& options) {
  const Index n = ContactModel::unknowns(problem);
  if (options.space.is_null())
    return Thyra::defaultSpmdVectorSpace<double>(n);
  if (options.space->dim() != n)
    throw bem::InputError("the contact problem has ", n,
                          " unknowns, but the space for them has ", options.space->dim());
  const auto space = Teuchos::rcp_dynamic_cast<const SpmdSpace>(options.space);
  if (space.is_null())
    throw bem::InputError(
        "the space for the contact problem's unknowns must give each process a "
        "contiguous piece (Thyra::SpmdVectorSpaceBase)");
  return space;
}

// The model only evaluates; the caller tests convergence.
constexpr double noTolerance = 0;

}  // namespace

struct ContactModel::Member {
  Member(const ProblemFamily& family, const Factors& factors_)
      : factors(factors_),
        problem(family.at(factors)),
        equation(problem, Equation::Bound::Differentiated, noTolerance) {}

  Factors factors;
  Problem problem;
  Equation equation;
};

ContactModel::ContactModel(const ContactSystem& system, const Options& options)
    : ContactModel(system.numbers(), system.gap(), options) {}

ContactModel::ContactModel(ProblemFamily family, const Options& options)
    : family_(std::move(family)),
      stress_(family_->original().stress),
      space_(spaceOf(family_->original(), options)),
      parameterSpace_(
          Thyra::locallyReplicatedDefaultSpmdVectorSpace<double>(space_->getComm(), 1)) {}

ContactModel::ContactModel(const Equation& equation)
    : stress_(1),
      space_(spaceOf(equation.problem(), {})),
      single_(std::shared_ptr<const void>(), &equation) {}

RCP<Thyra::VectorBase<double>> ContactModel::vector(const Vector& unknowns) const {
  const RCP<Thyra::VectorBase<double>> x = Thyra::createMember(*get_x_space());
  scatter(*space_, unknowns, 1 / stress_, 0, *x);
  return x;
}

RCP<Thyra::VectorBase<double>> ContactModel::point(const State& state) const {
  return vector(pack(family().original(), state));
}

std::shared_ptr<const Linearisation> ContactModel::at(
    const NOX::Abstract::Group& group) const {
  return at(dynamic_cast<const NOX::Thyra::Vector&>(group.getX()).getThyraVector(), {});
}

std::shared_ptr<const Linearisation> ContactModel::at(const Thyra::VectorBase<double>& x,
                                                      const Factors& factors) const {
  const std::shared_ptr<const Equation> equation = equationAt(factors);
  Vector unknowns = gathered(*space_, x);
  for (double& value : unknowns)
    value *= stress_;
  for (const auto& known : points_)
    if (known != nullptr && &known->equation() == equation.get() &&
        known->evaluation().unknowns == unknowns)
      return known;
  points_[1] = std::move(points_[0]);
  points_[0] =
      std::make_shared<const Linearisation>(equation, equation->at(std::move(unknowns)));
  return points_[0];
}

State ContactModel::state(const Thyra::VectorBase<double>& x) const {
  Vector unknowns = gathered(*space_, x);
  for (double& value : unknowns)
    value *= stress_;
  return unpack(family().original(), unknowns);
}

RCP<const Thyra::VectorSpaceBase<double>> ContactModel::get_p_space(int) const {
  return parameterSpace_;
}

RCP<const Teuchos::Array<std::string>> ContactModel::get_p_names(int l) const {
  constexpr const char* names[] = {"Load Factor", "Friction Factor", "Increment"};
  return Teuchos::rcp(new Teuchos::Array<std::string>(1, names[l]));
}

Base::InArgs<double> ContactModel::createInArgs() const {
  Base::InArgsSetup<double> in;
  in.setModelEvalDescription(description());
  in.setSupports(Base::IN_ARG_x);
  in.set_Np(parameters());
  return std::move(in);
}

Base::InArgs<double> ContactModel::getNominalValues() const {
  Base::InArgs<double> in = createInArgs();
  in.set_x(vector(Vector(space_->dim(), 0.0)));
  for (int l = 0; l < parameters(); ++l) {
    const RCP<Thyra::VectorBase<double>> one = Thyra::createMember(*parameterSpace_);
    Thyra::assign(one.ptr(), 1.0);
    in.set_p(l, one);
  }
  return in;
}

Base::OutArgs<double> ContactModel::createOutArgsImpl() const {
  Base::OutArgsSetup<double> out;
  out.setModelEvalDescription(description());
  out.set_Np_Ng(parameters(), 0);
  out.setSupports(Base::OUT_ARG_f);
  out.setSupports(Base::OUT_ARG_W_op);
  for (int l = 0; l < parameters(); ++l)
    out.setSupports(Base::OUT_ARG_DfDp, l, Base::DERIV_MV_JACOBIAN_FORM);
  return std::move(out);
}

RCP<Thyra::LinearOpBase<double>> ContactModel::create_W_op() const {
  return Teuchos::rcp(new ContactJacobian(space_, 1 / stress_, failure()));
}

RCP<const Thyra::LinearOpWithSolveFactoryBase<double>> ContactModel::get_W_factory()
    const {
  return Teuchos::rcp(new ContactJacobianFactory(space_, 1 / stress_, failure()));
}

std::shared_ptr<const Equation> ContactModel::equationAt(const Factors& factors) const {
  if (single_ != nullptr)
    return single_;
  if (latest_ == nullptr || latest_->factors.load != factors.load ||
      latest_->factors.friction != factors.friction ||
      latest_->factors.increment != factors.increment)
    latest_ = std::make_shared<const Member>(*family_, factors);
  return {latest_, &latest_->equation};
}

void ContactModel::evalModelImpl(const Base::InArgs<double>& in,
                                 const Base::OutArgs<double>& out) const {
  const auto factor = [&](Parameter l) {
    return l >= parameters() || in.get_p(l).is_null() ? 1.0
                                                      : Thyra::get_ele(*in.get_p(l), 0);
  };
  const auto point = at(*in.get_x(), {factor(Load), factor(Friction), factor(Increment)});
  const contact::Evaluation& e = point->evaluation();

  if (const auto f = out.get_f(); !f.is_null())
    scatter(*space_, e.residual, 1 / stress_, 0, *f);
  if (const auto w = out.get_W_op(); !w.is_null())
    Teuchos::dyn_cast<ContactJacobian>(*w).set(point);
  using ByParameter =
      Vector (ProblemFamily::*)(const Equation&, const contact::Evaluation&) const;
  constexpr ByParameter derivatives[] = {&ProblemFamily::loadDerivative,
                                         &ProblemFamily::frictionDerivative,
                                         &ProblemFamily::incrementDerivative};
  for (int l = 0; l < parameters(); ++l)
    if (const auto dfdp = out.get_DfDp(l).getMultiVector(); !dfdp.is_null())
      scatter(*space_, ((*family_).*derivatives[l])(point->equation(), e), 1 / stress_, 0,
              *dfdp->col(0));
}

}  // namespace epafi::contact
