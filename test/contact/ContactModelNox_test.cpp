// NOX and LOCA find on the model what the solver finds.
#include "Largest.hpp"
#include "contact/ModelSample.hpp"
#include "contact/Solve.hpp"

#include <NOX.H>
#include <NOX_Thyra.H>
#include <Teuchos_UnitTestHarness.hpp>

#include <LOCA.H>
#include <LOCA_Thyra.H>
#include <cmath>
#include <random>

namespace {

namespace contact = epafi::contact;
namespace test = epafi::test;
using contact::ContactModel;
using contact::Factors;
using contact::Index;
using contact::State;
using test::largestDifference;
using test::ModelSample;
using test::modelSample;
using test::solve;
using Teuchos::RCP;
using Teuchos::rcp;
using ThyraVector = Thyra::VectorBase<double>;

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
    const ModelSample s =
        modelSample(laws[k % 3], k / 3, 5e-6, random);  // 0 to 2 rigid motions
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
    TEST_COMPARE(largestDifference(found.multiplier, expected.multiplier), <,
                 1e-10 * 5e-6);
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

std::vector<Path::Point> follow(const ModelSample& s, const Continuation& path) {
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
      const ModelSample s = modelSample("Coulomb", rigidMotions, 4e-6, random);
      const std::vector<Path::Point> points = follow(s, path);
      TEST_COMPARE(points.size(), >=, 5u);
      for (const Path::Point& point : points) {
        Factors factors;
        (path.parameter == ContactModel::Load ? factors.load : factors.friction) =
            point.parameter;
        const contact::ProblemFamily family(s.problem, s.gap);
        const State expected = solve(family.at(factors), {}, {}).state;
        TEST_COMPARE(largestDifference(point.state.multiplier, expected.multiplier), <,
                     1e-9 * 4e-6);
      }
      if (!points.empty())
        TEST_COMPARE(std::abs(points.back().parameter - path.to), <, 1e-9);
    }
}

}  // namespace
