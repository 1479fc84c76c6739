#pragma once

#include "contact/newton/NewtonSystem.hpp"

#include <Teuchos_ParameterListAcceptorDefaultBase.hpp>
#include <Thyra_LinearOpWithSolveBase.hpp>
#include <Thyra_LinearOpWithSolveFactoryBase.hpp>
#include <Thyra_SpmdVectorSpaceBase.hpp>
#include <Thyra_VectorBase.hpp>

#include <memory>

namespace epafi::contact {

/// A vector space in which each process has a contiguous piece (of Tpetra or of Thyra).
using SpmdSpace = Thyra::SpmdVectorSpaceBase<double>;

/// All entries, on every process.  Collective.
Vector gathered(const SpmdSpace& space, const Thyra::VectorBase<double>& x);

/// x = scale values + shift x, each process its own piece; with shift = 0, x may be NaN.
void scatter(const SpmdSpace& space, const Vector& values, double scale, double shift,
             Thyra::VectorBase<double>& x);

/// The contact equation at one point, with the system of its generalised Jacobian.
class Linearisation {
 public:
  Linearisation(std::shared_ptr<const Equation> equation, Evaluation evaluation)
      : equation_(std::move(equation)), evaluation_(std::move(evaluation)) {}

  const Equation& equation() const { return *equation_; }
  const Evaluation& evaluation() const { return evaluation_; }

  /// Factored on the first call.
  /// \throws SingularJacobian
  const NewtonSystem& system() const;

 private:
  std::shared_ptr<const Equation> equation_;
  Evaluation evaluation_;
  mutable std::unique_ptr<NewtonSystem> system_;
};

/// How a solve with the Jacobian reports failure: by its status (Told), or by an exception
/// SingularJacobian or NoBalance (Thrown).
enum class SolveFailure { Told, Thrown };

/// The generalised Jacobian J of the contact equation: applies itself and, dense and
/// replicated, its inverse.
///
/// All calls are collective.  Jᵀ is applied, not solved with.
class ContactJacobian final : public Thyra::LinearOpWithSolveBase<double> {
 public:
  /// `scale`: what the residual is multiplied by, see ContactModel.
  ContactJacobian(Teuchos::RCP<const SpmdSpace> space, double scale, SolveFailure failure)
      : space_(std::move(space)), scale_(scale), failure_(failure) {}

  void set(std::shared_ptr<const Linearisation> at) { at_ = std::move(at); }
  /// Shares the current linearisation of `other`; later changes of `other` have no effect.
  void share(const ContactJacobian& other) { at_ = other.at_; }

  Teuchos::RCP<const Thyra::VectorSpaceBase<double>> range() const override {
    return space_;
  }
  Teuchos::RCP<const Thyra::VectorSpaceBase<double>> domain() const override {
    return space_;
  }

 private:
  using MultiVector = Thyra::MultiVectorBase<double>;

  /// \throws std::logic_error before the first evaluation.
  const Linearisation& at() const;

  bool opSupportedImpl(Thyra::EOpTransp) const override { return true; }
  void applyImpl(Thyra::EOpTransp transpose, const MultiVector& x,
                 const Teuchos::Ptr<MultiVector>& y, double alpha,
                 double beta) const override;
  bool solveSupportsImpl(Thyra::EOpTransp transpose) const override {
    return Thyra::real_trans(transpose) == Thyra::NOTRANS;
  }
  bool solveSupportsSolveMeasureTypeImpl(Thyra::EOpTransp transpose,
                                         const Thyra::SolveMeasureType&) const override {
    return solveSupportsImpl(transpose);
  }
  /// x = J⁻¹ b.  If b is the residual and its balance requires a rigid motion that
  /// nothing constrains (no contact, or all slips), -x is placingStep() instead.  With
  /// another b, or a singular J, the solve fails.
  Thyra::SolveStatus<double> solveImpl(
      Thyra::EOpTransp transpose, const MultiVector& b,
      const Teuchos::Ptr<MultiVector>& x,
      Teuchos::Ptr<const Thyra::SolveCriteria<double>> criteria) const override;

  Vector solved(const Vector& b) const;

  Teuchos::RCP<const SpmdSpace> space_;
  double scale_;
  SolveFailure failure_;
  std::shared_ptr<const Linearisation> at_;
};

/// Factory of ContactJacobian, which has no parameters.
class ContactJacobianFactory final
    : public Thyra::LinearOpWithSolveFactoryBase<double>,
      virtual public Teuchos::ParameterListAcceptorDefaultBase {
 public:
  ContactJacobianFactory(Teuchos::RCP<const SpmdSpace> space, double scale,
                         SolveFailure failure)
      : space_(std::move(space)), scale_(scale), failure_(failure) {}

  bool isCompatible(const Thyra::LinearOpSourceBase<double>& source) const override;
  Teuchos::RCP<Thyra::LinearOpWithSolveBase<double>> createOp() const override {
    return Teuchos::rcp(new ContactJacobian(space_, scale_, failure_));
  }
  void initializeOp(const Teuchos::RCP<const Thyra::LinearOpSourceBase<double>>& source,
                    Thyra::LinearOpWithSolveBase<double>* op,
                    Thyra::ESupportSolveUse use) const override;
  void uninitializeOp(Thyra::LinearOpWithSolveBase<double>*,
                      Teuchos::RCP<const Thyra::LinearOpSourceBase<double>>*,
                      Teuchos::RCP<const Thyra::PreconditionerBase<double>>*,
                      Teuchos::RCP<const Thyra::LinearOpSourceBase<double>>*,
                      Thyra::ESupportSolveUse*) const override {}

  void setParameterList(const Teuchos::RCP<Teuchos::ParameterList>& list) override {
    setMyParamList(list);
  }

 private:
  Teuchos::RCP<const SpmdSpace> space_;
  double scale_;
  SolveFailure failure_;
};

}  // namespace epafi::contact
