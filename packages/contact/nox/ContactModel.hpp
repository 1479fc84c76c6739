#pragma once

#include "contact/equation/ProblemFamily.hpp"
#include "contact/nox/ContactJacobian.hpp"
#include "contact/system/ContactSystem.hpp"

#include <Thyra_StateFuncModelEvaluatorBase.hpp>

#include <array>
#include <memory>
#include <optional>

namespace NOX::Abstract {
class Group;
}

namespace epafi::contact {

/// The condensed contact problem as Thyra::ModelEvaluator, for NOX, LOCA and others:
///
///   x = (λ, α) / σ,   f(x) = F(σ x) / σ,   σ = Problem::stress, the size of the load;
///
/// F: see Equation.  Norms of f are relative to the load.
///
///   parameters   p₀ load factor, p₁ friction factor, of a step of a path p₂ the increment (see
///                Factors), 1 unless given
///   f            the residual
///   W_op, W      an element of the generalised Jacobian; W solves with it, dense
///   DfDp(0, 1, 2)  of the same element, by columns; LOCA 13.2 prefers difference quotients
///
/// F is semismooth: Newton's method with full steps converges locally and superlinearly.
/// For a start near the solution use solve().
class ContactModel final : public Thyra::StateFuncModelEvaluatorBase<double> {
 public:
  enum Parameter { Load = 0, Friction = 1, Increment = 2 };

  struct Options {
    /// How x and f are distributed: unknowns() entries, each process a contiguous piece,
    /// as Thyra::createVectorSpace<double>(map) has it for a Tpetra map.  Null: one
    /// process, no MPI.  The equation is replicated, and evaluating it is collective.
    Teuchos::RCP<const Thyra::VectorSpaceBase<double>> space;
  };

  /// Number of unknowns of a problem: λ and α.
  static Index unknowns(const Problem& problem) {
    return problem.size() + problem.rigidMotions();
  }

  /// Of a system with a Bedding (ContactSystem::depth) the solution is that of the numbers, short of a
  /// thousandth of what the bed gives way: corrected() takes that off.
  /// \throws bem::InputError if the space is of another kind or dimension.
  explicit ContactModel(const ContactSystem& system) : ContactModel(system, Options()) {}
  ContactModel(const ContactSystem& system, const Options& options);
  ContactModel(const Problem& problem, const Vector& gap, const Options& options)
      : ContactModel(ProblemFamily(problem, gap), options) {}
  /// With parameters as in ProblemFamily; a step of a path has three.
  ContactModel(ProblemFamily family, const Options& options);

  /// A single equation: x = (λ, α), f = F, without parameters, on one process.  Solves
  /// with W throw SingularJacobian and NoBalance.  The equation must outlive the model.
  explicit ContactModel(const Equation& equation);

  /// The linearisation at x; those of the latest two points are cached.  Collective.
  std::shared_ptr<const Linearisation> at(const Thyra::VectorBase<double>& x,
                                          const Factors& factors) const;

  /// The same at the point of a NOX group.  \pre made of a single equation
  std::shared_ptr<const Linearisation> at(const NOX::Abstract::Group& group) const;

  /// x = (λ, α) / σ.  Collective.
  Teuchos::RCP<Thyra::VectorBase<double>> vector(const Vector& unknowns) const;

  /// x of a state (empty vectors are zero), and the state of an x.  Collective.
  Teuchos::RCP<Thyra::VectorBase<double>> point(const State& state) const;
  State state(const Thyra::VectorBase<double>& x) const;

  /// \pre not of a single equation
  const ProblemFamily& family() const { return *family_; }

  Teuchos::RCP<const Thyra::VectorSpaceBase<double>> get_x_space() const override {
    return space_;
  }
  Teuchos::RCP<const Thyra::VectorSpaceBase<double>> get_f_space() const override {
    return space_;
  }
  Teuchos::RCP<const Thyra::VectorSpaceBase<double>> get_p_space(int l) const override;
  Teuchos::RCP<const Teuchos::Array<std::string>> get_p_names(int l) const override;
  Thyra::ModelEvaluatorBase::InArgs<double> getNominalValues() const override;
  Thyra::ModelEvaluatorBase::InArgs<double> createInArgs() const override;
  Teuchos::RCP<Thyra::LinearOpBase<double>> create_W_op() const override;
  Teuchos::RCP<const Thyra::LinearOpWithSolveFactoryBase<double>> get_W_factory()
      const override;

 private:
  struct Member;  // one problem of the family and its equation

  Thyra::ModelEvaluatorBase::OutArgs<double> createOutArgsImpl() const override;
  /// \throws bem::InputError as ProblemFamily::at.
  void evalModelImpl(
      const Thyra::ModelEvaluatorBase::InArgs<double>& in,
      const Thyra::ModelEvaluatorBase::OutArgs<double>& out) const override;
  std::shared_ptr<const Equation> equationAt(const Factors& factors) const;

  int parameters() const { return family_ ? (family_->isStep() ? 3 : 2) : 0; }
  SolveFailure failure() const {
    return family_ ? SolveFailure::Told : SolveFailure::Thrown;
  }

  std::optional<ProblemFamily> family_;
  double stress_;
  Teuchos::RCP<const SpmdSpace> space_;
  Teuchos::RCP<const Thyra::VectorSpaceBase<double>> parameterSpace_;
  std::shared_ptr<const Equation> single_;
  mutable std::shared_ptr<const Member> latest_;  // parameters change seldom
  mutable std::array<std::shared_ptr<const Linearisation>, 2> points_;
};

}  // namespace epafi::contact
