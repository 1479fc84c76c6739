#include "contact/nox/ContactModel.hpp"

#include "Largest.hpp"
#include "bem/base/Error.hpp"
#include "contact/RandomProblem.hpp"
#include "contact/Solve.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <Thyra_LinearOpWithSolveBase.hpp>
#include <Thyra_LinearOpWithSolveFactoryHelpers.hpp>
#include <Thyra_MultiVectorBase.hpp>
#include <Thyra_TestingTools.hpp>
#include <Thyra_VectorStdOps.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace {

namespace bem = epafi::bem;
namespace contact = epafi::contact;
namespace test = epafi::test;
using contact::ContactModel;
using contact::Factors;
using contact::Index;
using contact::Problem;
using contact::State;
using contact::Vector;
using test::largestDifference;
using test::solve;
using Teuchos::RCP;
using Teuchos::rcp;
using ThyraVector = Thyra::VectorBase<double>;

struct ModelSample {
  Problem problem;
  Vector gap;
};

/// A problem of a load of the given size, with gaps.
ModelSample modelSample(const char* law, Index rigidMotions, double stress,
                        std::mt19937& random) {
  test::Recipe recipe = test::Recipe::of(law, 0.4, rigidMotions);
  recipe.normals = 12;
  recipe.softness = 1;
  ModelSample result{randomProblem(recipe, random), {}};
  Problem& problem = result.problem;
  for (Index i = 0; i < problem.normals; ++i)
    result.gap.push_back(0.1 * std::sqrt(problem.flexibility(i, i)) *
                         std::uniform_real_distribution<double>(0, 1)(random));
  const auto scale = [&](double& value) { value *= stress; };
  std::for_each(problem.offset.begin(), problem.offset.end(), scale);
  std::for_each(problem.rigidLoad.begin(), problem.rigidLoad.end(), scale);
  std::for_each(result.gap.begin(), result.gap.end(), scale);
  for (contact::Tangential& t : problem.tangentials)
    if (!t.followsPressure())
      t = t.scaled(stress);
  problem.stress = stress;
  return result;
}

RCP<ThyraVector> randomVector(const ContactModel& model, std::mt19937& random) {
  std::normal_distribution<double> normal;
  const RCP<ThyraVector> x = Thyra::createMember(*model.get_x_space());
  for (Index i = 0; i < x->space()->dim(); ++i)
    Thyra::set_ele(i, normal(random), x.ptr());
  return x;
}

RCP<ThyraVector> sum(const ThyraVector& a, double t, const ThyraVector& b) {
  const RCP<ThyraVector> c = a.clone_v();
  Thyra::Vp_StV(c.ptr(), t, b);
  return c;
}

// Not the largest entry: Thyra's maximum passes over NaN.
double distance(const ThyraVector& a, const ThyraVector& b) {
  return Thyra::norm_2(*sum(a, -1, b));
}

Thyra::ModelEvaluatorBase::InArgs<double> inArgs(const ContactModel& model,
                                                 const RCP<const ThyraVector>& x,
                                                 const Factors& factors) {
  auto in = model.createInArgs();
  in.set_x(x);
  const double values[] = {factors.load, factors.friction};
  for (int l = 0; l < 2; ++l) {
    const RCP<ThyraVector> p = Thyra::createMember(*model.get_p_space(l));
    Thyra::assign(p.ptr(), values[l]);
    in.set_p(l, p);
  }
  return in;
}

RCP<ThyraVector> residual(const ContactModel& model, const RCP<const ThyraVector>& x,
                          const Factors& factors) {
  auto out = model.createOutArgs();
  const RCP<ThyraVector> f = Thyra::createMember(*model.get_f_space());
  out.set_f(f);
  model.evalModel(inArgs(model, x, factors), out);
  return f;
}

RCP<Thyra::LinearOpBase<double>> jacobian(const ContactModel& model,
                                          const RCP<const ThyraVector>& x,
                                          const Factors& factors) {
  auto out = model.createOutArgs();
  const RCP<Thyra::LinearOpBase<double>> w = model.create_W_op();
  out.set_W_op(w);
  model.evalModel(inArgs(model, x, factors), out);
  return w;
}

RCP<ThyraVector> derivative(const ContactModel& model, const RCP<const ThyraVector>& x,
                            const Factors& factors, int parameter) {
  auto out = model.createOutArgs();
  const RCP<Thyra::MultiVectorBase<double>> column =
      Thyra::createMembers(*model.get_f_space(), 1);
  out.set_DfDp(parameter, Thyra::ModelEvaluatorBase::Derivative<double>(
                              column, Thyra::ModelEvaluatorBase::DERIV_MV_BY_COL));
  model.evalModel(inArgs(model, x, factors), out);
  return column->col(0);
}

RCP<ThyraVector> times(const Thyra::LinearOpBase<double>& a, Thyra::EOpTransp transpose,
                       const ThyraVector& x) {
  const RCP<ThyraVector> y = Thyra::createMember(*a.range());
  Thyra::apply<double>(a, transpose, x, y.ptr());
  return y;
}

// Every law and number of rigid motions; load and friction factor off one.
template <class Claim>
void forAll(const Claim& claim) {
  std::mt19937 random(71);
  for (const char* law : {"None", "Tresca", "Coulomb"})
    for (const Index rigidMotions : {0, 1, 2})
      for (const double stress : {1.0, 2e-7}) {
        const ModelSample s = modelSample(law, rigidMotions, stress, random);
        const ContactModel model(s.problem, s.gap, {});
        claim(s, model, Factors{1.3, 0.7}, random);
      }
}

TEUCHOS_UNIT_TEST(ContactModel, residualVanishesAtTheSolutionOfTheScaledProblem) {
  std::mt19937 random(72);
  for (const char* law : {"None", "Tresca", "Coulomb"})
    for (const Index rigidMotions : {0, 1}) {
      const ModelSample s = modelSample(law, rigidMotions, 3e-6, random);
      const ContactModel model(s.problem, s.gap, {});
      for (const Factors factors : {Factors{1, 1}, Factors{1.5, 0.5}, Factors{0.5, 0}}) {
        const Problem scaled = model.family().at(factors);
        const contact::Solution solution = solve(scaled, {}, {});
        TEST_ASSERT(solution.report.status == contact::Status::Converged);
        const RCP<ThyraVector> x = model.point(solution.state);
        TEST_COMPARE(Thyra::norm_2(*residual(model, x, factors)), <, 1e-11);
        TEST_COMPARE(
            largestDifference(model.state(*x).multiplier, solution.state.multiplier), <,
            1e-15 * 3e-6 * 100);
      }
    }
}

TEUCHOS_UNIT_TEST(ContactModel, jacobianIsTheDerivativeAwayFromKinks) {
  forAll([&](const ModelSample&, const ContactModel& model, const Factors& factors,
             std::mt19937& random) {
    const RCP<ThyraVector> x = randomVector(model, random);
    const RCP<ThyraVector> d = randomVector(model, random);
    const double h = 1e-7;
    const RCP<ThyraVector> quotient = residual(model, sum(*x, h, *d), factors);
    Thyra::Vp_StV(quotient.ptr(), -1.0, *residual(model, sum(*x, -h, *d), factors));
    Thyra::scale(1 / (2 * h), quotient.ptr());
    const RCP<ThyraVector> slope =
        times(*jacobian(model, x, factors), Thyra::NOTRANS, *d);
    TEST_COMPARE(distance(*slope, *quotient), <, 1e-6 * Thyra::norm_2(*slope));
  });
}

TEUCHOS_UNIT_TEST(ContactModel, dfdpAreTheDerivativesAwayFromKinks) {
  forAll([&](const ModelSample&, const ContactModel& model, const Factors& factors,
             std::mt19937& random) {
    const RCP<ThyraVector> x = randomVector(model, random);
    const double h = 1e-7;
    for (const int l : {0, 1}) {
      Factors more = factors;
      Factors less = factors;
      (l == 0 ? more.load : more.friction) += h;
      (l == 0 ? less.load : less.friction) -= h;
      const RCP<ThyraVector> quotient = residual(model, x, more);
      Thyra::Vp_StV(quotient.ptr(), -1.0, *residual(model, x, less));
      Thyra::scale(1 / (2 * h), quotient.ptr());
      const RCP<ThyraVector> slope = derivative(model, x, factors, l);
      TEST_COMPARE(distance(*slope, *quotient), <, 1e-6);
    }
  });
}

TEUCHOS_UNIT_TEST(ContactModel, transposedJacobianIsTheAdjoint) {
  forAll([&](const ModelSample&, const ContactModel& model, const Factors& factors,
             std::mt19937& random) {
    const auto w = jacobian(model, randomVector(model, random), factors);
    const RCP<ThyraVector> u = randomVector(model, random);
    const RCP<ThyraVector> v = randomVector(model, random);
    const double forward = Thyra::dot(*v, *times(*w, Thyra::NOTRANS, *u));
    const double backward = Thyra::dot(*u, *times(*w, Thyra::TRANS, *v));
    TEST_COMPARE(std::abs(forward - backward), <, 1e-12 * (1 + std::abs(forward)));
  });
}

TEUCHOS_UNIT_TEST(ContactModel, wSolvesWithTheJacobian) {
  int solved = 0;
  forAll([&](const ModelSample& s, const ContactModel& model, const Factors& factors,
             std::mt19937& random) {
    const State near = solve(s.problem, {}, {}).state;
    const auto w = jacobian(model, model.point(near), factors);
    const auto inverse = Thyra::linearOpWithSolve<double>(*model.get_W_factory(), w);
    const RCP<ThyraVector> b = randomVector(model, random);
    const RCP<ThyraVector> x = Thyra::createMember(*model.get_x_space());
    const auto status = Thyra::solve<double>(*inverse, Thyra::NOTRANS, *b, x.ptr());
    if (status.solveStatus != Thyra::SOLVE_STATUS_CONVERGED)
      return;  // everything slips: nothing holds the rigid motions
    ++solved;
    TEST_COMPARE(distance(*times(*w, Thyra::NOTRANS, *x), *b), <,
                 1e-10 * (1 + Thyra::norm_2(*x)));
  });
  TEST_EQUALITY(solved, 18);
}

TEUCHOS_UNIT_TEST(ContactModel, wKeepsItsPointWhenTheModelMovesOn) {
  std::mt19937 random(74);
  const ModelSample s = modelSample("Coulomb", 0, 1, random);
  const ContactModel model(s.problem, s.gap, {});
  const RCP<ThyraVector> x = randomVector(model, random);
  const RCP<ThyraVector> d = randomVector(model, random);
  const auto first = jacobian(model, x, {1, 0.5});
  const RCP<ThyraVector> before = times(*first, Thyra::NOTRANS, *d);
  const auto second = jacobian(model, x, {1, 2});
  TEST_EQUALITY(distance(*times(*first, Thyra::NOTRANS, *d), *before), 0.0);
  TEST_COMPARE(distance(*times(*second, Thyra::NOTRANS, *d), *before), >, 0.0);
}

TEUCHOS_UNIT_TEST(ContactModel, aMotionThatNothingHoldsIsReportedByTheSolve) {
  std::mt19937 random(75);
  const ModelSample s = modelSample("None", 1, 1, random);
  const ContactModel model(s.problem, s.gap, {});
  State open;
  open.multiplier.assign(s.problem.size(), -100.0);
  const auto w = jacobian(model, model.point(open), {});
  const auto inverse = Thyra::linearOpWithSolve<double>(*model.get_W_factory(), w);
  const RCP<ThyraVector> b = randomVector(model, random);
  const RCP<ThyraVector> x = Thyra::createMember(*model.get_x_space());
  const auto status = Thyra::solve<double>(*inverse, Thyra::NOTRANS, *b, x.ptr());
  TEST_EQUALITY(status.solveStatus, Thyra::SOLVE_STATUS_UNCONVERGED);
  TEST_INEQUALITY(status.message.find("rigid motion"), std::string::npos);
}

TEUCHOS_UNIT_TEST(ContactModel, refusesWrongSizesAndFactors) {
  std::mt19937 random(76);
  const ModelSample s = modelSample("Coulomb", 0, 1, random);
  TEST_THROW(ContactModel(s.problem, {0.0}, {}), bem::InputError);
  const ContactModel model(s.problem, s.gap, {});
  ContactModel::Options options;
  options.space = model.get_p_space(0);
  TEST_THROW(ContactModel(s.problem, s.gap, options), bem::InputError);
  TEST_THROW(residual(model, randomVector(model, random), {1, -0.1}), bem::InputError);
  TEST_THROW(residual(model, randomVector(model, random), {std::nan(""), 1}),
             bem::InputError);
}

}  // namespace
