#include "contact/RandomProblem.hpp"
#include "contact/Solve.hpp"
#include "contact/nox/ContactModel.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <Thyra_LinearOpWithSolveFactoryHelpers.hpp>
#include <Thyra_MultiVectorStdOps.hpp>
#include <Thyra_TpetraThyraWrappers.hpp>
#include <Thyra_VectorStdOps.hpp>
#include <Tpetra_Core.hpp>

#include <random>

namespace {

namespace contact = epafi::contact;
namespace test = epafi::test;
using contact::ContactModel;
using contact::Problem;
using contact::State;
using contact::Vector;
using Teuchos::rcp;
using Base = Thyra::ModelEvaluatorBase;

Problem coulombProblem() {
  std::mt19937 random(81);
  test::Recipe recipe = test::Recipe::of("Coulomb", 0.4, 1);
  recipe.softness = 1;
  recipe.normals = 9;
  return randomProblem(recipe, random);
}

Vector joined(const State& state) {
  Vector all = state.multiplier;
  all.insert(all.end(), state.rigid.begin(), state.rigid.end());
  return all;
}

/// f, df/dp₀, df/dp₁, J f and J⁻¹ f at a point, whole.
std::vector<Vector> everything(const ContactModel& model, const State& state) {
  auto in = model.getNominalValues();
  in.set_x(model.point(state));
  auto out = model.createOutArgs();
  const auto f = Thyra::createMember(*model.get_f_space());
  out.set_f(f);
  const auto w = model.create_W_op();
  out.set_W_op(w);
  const auto slopes = Thyra::createMembers(*model.get_f_space(), 2);
  for (const int l : {0, 1})
    out.set_DfDp(
        l, Base::Derivative<double>(
               Teuchos::rcp_dynamic_cast<Thyra::MultiVectorBase<double>>(slopes->col(l)),
               Base::DERIV_MV_BY_COL));
  model.evalModel(in, out);

  const auto product = Thyra::createMembers(*model.get_f_space(), 2);
  Thyra::apply<double>(*w, Thyra::NOTRANS, *slopes, product.ptr());
  const auto inverse = Thyra::linearOpWithSolve<double>(*model.get_W_factory(), w);
  const auto solution = Thyra::createMember(*model.get_x_space());
  const auto status = Thyra::solve<double>(*inverse, Thyra::NOTRANS, *f, solution.ptr());
  std::vector<Vector> all;
  for (const auto& x :
       {f, slopes->col(0), slopes->col(1), product->col(0), product->col(1), solution})
    all.push_back(joined(model.state(*x)));
  all.push_back({status.solveStatus == Thyra::SOLVE_STATUS_CONVERGED ? 1.0 : 0.0});
  return all;
}

TEUCHOS_UNIT_TEST(ContactModel, isTheSameOnEveryNumberOfRanks) {
  const Problem problem = coulombProblem();
  const Vector gap(problem.normals, 0.01);
  State state = test::solve(problem).state;
  for (double& value : state.multiplier)
    value *= 1.1;  // so that f is not zero

  const ContactModel alone(problem, gap, {});
  ContactModel::Options options;
  options.space = Thyra::createVectorSpace<double>(rcp(new const Tpetra::Map<>(
      ContactModel::unknowns(problem), 0, Tpetra::getDefaultComm())));
  const ContactModel shared(problem, gap, options);
  TEST_COMPARE_ARRAYS(joined(shared.state(*shared.point(state))),
                      joined(alone.state(*alone.point(state))));

  const auto expected = everything(alone, state);
  const auto found = everything(shared, state);
  TEST_EQUALITY(expected.back().front(), 1.0);
  for (std::size_t k = 0; k < expected.size(); ++k)
    TEST_COMPARE_FLOATING_ARRAYS(found[k], expected[k], 1e-13);
}

}  // namespace
