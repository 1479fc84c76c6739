#include "contact/nox/ContactModel.hpp"

#include "bem/base/Error.hpp"
#include "contact/RandomProblem.hpp"
#include "contact/Solve.hpp"

#include <NOX.H>
#include <NOX_Thyra.H>
#include <Teuchos_UnitTestHarness.hpp>
#include <Thyra_LinearOpWithSolveBase.hpp>
#include <Thyra_LinearOpWithSolveFactoryHelpers.hpp>
#include <Thyra_MultiVectorBase.hpp>
#include <Thyra_TestingTools.hpp>
#include <Thyra_VectorStdOps.hpp>

#include <LOCA.H>
#include <LOCA_Thyra.H>
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
using test::solve;
using Teuchos::RCP;
using Teuchos::rcp;
using ThyraVector = Thyra::VectorBase<double>;

constexpr const char* projection = "Projection";
constexpr const char* fischerBurmeister = "Fischer-Burmeister";

struct Sample {
  Problem problem;
  Vector gap;
};

// A problem of a load of the given size, with gaps.
Sample sample(const char* law, Index rigidMotions, double stress, std::mt19937& random,
              int coupling = 0) {
  test::Recipe recipe;
  recipe.law = law;
  recipe.normals = 12;
  recipe.softness = 1;
  recipe.strength = 0.4;
  recipe.rigidMotions = rigidMotions;
  recipe.coupling = coupling;
  Sample result{randomProblem(recipe, random), {}};
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

double difference(const Vector& a, const Vector& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
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

// Every law, function and number of rigid motions; load and friction factor off one.
// Under Coulomb's with bounds that follow one pressure, and several.
template <class Claim>
void forAll(const Claim& claim) {
  std::mt19937 random(71);
  for (const char* law : {"None", "Tresca", "Coulomb"})
    for (const auto function : {projection, fischerBurmeister})
      for (const Index rigidMotions : {0, 1, 2})
        for (const double stress : {1.0, 2e-7}) {
          const int largest = law == std::string("Coulomb") ? 3 : 0;
          for (const int coupling : {0, largest}) {
            const Sample s = sample(law, rigidMotions, stress, random, coupling);
            ContactModel::Options options;
            options.complementarity = function;
            const ContactModel model(s.problem, s.gap, options);
            claim(s, model, Factors{1.3, 0.7}, random);
          }
        }
}

TEUCHOS_UNIT_TEST(ContactModel, residualVanishesAtTheSolutionOfTheScaledProblem) {
  std::mt19937 random(72);
  for (const char* law : {"None", "Tresca", "Coulomb"})
    for (const Index rigidMotions : {0, 1}) {
      const bool coupled = law == std::string("Coulomb") && rigidMotions == 0;
      const Sample s = sample(law, rigidMotions, 3e-6, random, coupled ? 2 : 0);
      const ContactModel model(s.problem, s.gap, {});
      for (const Factors factors : {Factors{1, 1}, Factors{1.5, 0.5}, Factors{0.5, 0}}) {
        const Problem scaled = model.family().at(factors);
        const contact::Solution solution = solve(scaled, {}, {});
        TEST_ASSERT(solution.report.status == contact::Status::Converged);
        const RCP<ThyraVector> x = model.point(solution.state);
        TEST_COMPARE(Thyra::norm_2(*residual(model, x, factors)), <, 1e-11);
        TEST_COMPARE(difference(model.state(*x).multiplier, solution.state.multiplier), <,
                     1e-15 * 3e-6 * 100);
      }
    }
}

/// Tractions grow, the gap does not: with all gaps closed beforehand a linear problem
/// would answer in proportion, with gaps left it must not.
TEUCHOS_UNIT_TEST(ContactModel, loadFactorScalesLoadsButNotTheGap) {
  std::mt19937 random(73);
  const Sample s = sample("Tresca", 1, 1, random);
  const contact::ProblemFamily family(s.problem, s.gap);
  const Problem unloaded = family.at({0, 1});
  const Problem doubled = family.at({2, 1});
  for (Index i = 0; i < s.problem.size(); ++i) {
    const double gap = i < s.problem.normals ? s.gap[i] : 0;
    TEST_COMPARE(std::abs(unloaded.offset[i] + gap), <, 1e-15);
    TEST_COMPARE(std::abs(doubled.offset[i] - (2 * s.problem.offset[i] + gap)), <, 1e-14);
  }
  TEST_COMPARE(std::abs(doubled.rigidLoad[0] - 2 * s.problem.rigidLoad[0]), <, 1e-15);
  TEST_EQUALITY(unloaded.rigidLoad[0], 0.0);
}

TEUCHOS_UNIT_TEST(ContactModel, jacobianIsTheDerivativeAwayFromKinks) {
  forAll([&](const Sample&, const ContactModel& model, const Factors& factors,
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
  forAll([&](const Sample&, const ContactModel& model, const Factors& factors,
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
  forAll([&](const Sample&, const ContactModel& model, const Factors& factors,
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
  forAll([&](const Sample& s, const ContactModel& model, const Factors& factors,
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
  TEST_COMPARE(solved, >=, 30);
}

TEUCHOS_UNIT_TEST(ContactModel, wKeepsItsPointWhenTheModelMovesOn) {
  std::mt19937 random(74);
  const Sample s = sample("Coulomb", 0, 1, random);
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
  const Sample s = sample("None", 1, 1, random);
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
  const Sample s = sample("Coulomb", 0, 1, random);
  TEST_THROW(ContactModel(s.problem, {0.0}, {}), bem::InputError);
  const ContactModel model(s.problem, s.gap, {});
  ContactModel::Options options;
  options.space = model.get_p_space(0);
  TEST_THROW(ContactModel(s.problem, s.gap, options), bem::InputError);
  TEST_THROW(residual(model, randomVector(model, random), {1, -0.1}), bem::InputError);
  TEST_THROW(residual(model, randomVector(model, random), {std::nan(""), 1}),
             bem::InputError);
}

RCP<NOX::StatusTest::Generic> untilConverged() {
  const auto norm =
      rcp(new NOX::StatusTest::NormF(1e-11, NOX::StatusTest::NormF::Unscaled));
  const auto steps = rcp(new NOX::StatusTest::MaxIters(30));
  return rcp(new NOX::StatusTest::Combo(NOX::StatusTest::Combo::OR, norm, steps));
}

void setNewton(Teuchos::ParameterList& nox) {
  nox.set("Nonlinear Solver", "Line Search Based");
  nox.sublist("Line Search").set("Method", "Full Step");
  nox.sublist("Direction").sublist("Newton").set("Rescue Bad Newton Solve", false);
  nox.sublist("Printing").set("Output Information", 0);
}

TEUCHOS_UNIT_TEST(ContactModel, noxFindsWhatSolveFinds) {
  std::mt19937 random(77);
  for (int k = 0; k < 9; ++k) {
    const char* laws[] = {"None", "Tresca", "Coulomb"};
    const Sample s = sample(laws[k % 3], k / 3, 5e-6, random);  // 0 to 2 rigid motions
    const auto model = rcp(new ContactModel(s.problem, s.gap, {}));
    const RCP<Teuchos::ParameterList> list = Teuchos::parameterList();
    setNewton(*list);
    const auto start = model->getNominalValues().get_x()->clone_v();
    const auto group = rcp(new NOX::Thyra::Group(NOX::Thyra::Vector(start), model));
    const auto solver = NOX::Solver::buildSolver(group, untilConverged(), list);
    TEST_EQUALITY(solver->solve(), NOX::StatusTest::Converged);
    const auto& x =
        Teuchos::dyn_cast<const NOX::Thyra::Vector>(solver->getSolutionGroup().getX());
    const State found = model->state(x.getThyraVector());
    const State expected = solve(s.problem, {}, {}).state;
    TEST_COMPARE(difference(found.multiplier, expected.multiplier), <, 1e-10 * 5e-6);
  }
}

// What LOCA saw at each point of its path.
class Path final : public LOCA::Thyra::SaveDataStrategy {
 public:
  struct Point {
    double parameter;
    State state;
  };

  Path(const ContactModel& model, std::vector<Point>& points)
      : model_(model), points_(points) {}

  void saveSolution(const NOX::Abstract::Vector& x, double parameter) override {
    const auto& vector = Teuchos::dyn_cast<const NOX::Thyra::Vector>(x);
    points_.push_back({parameter, model_.state(vector.getThyraVector())});
  }

 private:
  const ContactModel& model_;
  std::vector<Point>& points_;
};

struct Continuation {
  const char* method;
  const char* predictor;
  int parameter;
  double from;
  double to;
};

std::vector<Path::Point> follow(const Sample& s, const Continuation& path) {
  const auto model = rcp(new ContactModel(s.problem, s.gap, {}));
  const RCP<Teuchos::ParameterList> list = Teuchos::parameterList();
  setNewton(list->sublist("NOX"));
  Teuchos::ParameterList& loca = list->sublist("LOCA");
  loca.sublist("Stepper")
      .set("Continuation Method", path.method)
      .set("Continuation Parameter", "p")
      .set("Initial Value", path.from)
      .set("Min Value", path.from)
      .set("Max Value", path.to)
      .set("Max Steps", 200)
      .set("Max Nonlinear Iterations", 30)
      .set("Compute Eigenvalues", false);
  loca.sublist("Predictor").set("Method", path.predictor);
  loca.sublist("Step Size")
      .set("Method", "Adaptive")
      .set("Initial Step Size", 0.1 * (path.to - path.from))
      .set("Max Step Size", 0.2 * (path.to - path.from))
      .set("Min Step Size", 1e-6);

  Factors first;
  (path.parameter == ContactModel::Load ? first.load : first.friction) = path.from;
  const RCP<ThyraVector> start =
      model->point(solve(model->family().at(first), {}, {}).state);
  std::vector<Path::Point> points;
  LOCA::ParameterVector parameters;
  parameters.addParameter("p", path.from);
  const RCP<LOCA::GlobalData> data = LOCA::createGlobalData(list);
  {
    const auto group = rcp(new LOCA::Thyra::Group(data, NOX::Thyra::Vector(start), model,
                                                  parameters, path.parameter));
    group->setSaveDataStrategy(rcp(new Path(*model, points)));
    LOCA::Stepper stepper(data, group, untilConverged(), list);
    if (stepper.run() != LOCA::Abstract::Iterator::Finished)
      points.clear();
  }
  LOCA::destroyGlobalData(data);
  return points;
}

TEUCHOS_UNIT_TEST(ContactModel, locaFollowsTheSolutionsOfSolveOverBothFactors) {
  for (const Index rigidMotions : {0, 1})
    for (const Continuation& path :
         {Continuation{"Natural", "Constant", ContactModel::Friction, 0, 2},
          Continuation{"Natural", "Tangent", ContactModel::Friction, 0, 2},
          Continuation{"Arc Length", "Tangent", ContactModel::Friction, 0.1, 2},
          Continuation{"Natural", "Tangent", ContactModel::Load, 0.2, 2},
          Continuation{"Arc Length", "Secant", ContactModel::Load, 0.2, 2}}) {
      std::mt19937 random(78);
      const Sample s = sample("Coulomb", rigidMotions, 4e-6, random);
      const std::vector<Path::Point> points = follow(s, path);
      TEST_COMPARE(points.size(), >=, 5u);
      for (const Path::Point& point : points) {
        Factors factors;
        (path.parameter == ContactModel::Load ? factors.load : factors.friction) =
            point.parameter;
        const contact::ProblemFamily family(s.problem, s.gap);
        const State expected = solve(family.at(factors), {}, {}).state;
        TEST_COMPARE(difference(point.state.multiplier, expected.multiplier), <,
                     1e-9 * 4e-6);
      }
      if (!points.empty())
        TEST_COMPARE(std::abs(points.back().parameter - path.to), <, 1e-9);
    }
}

}  // namespace
