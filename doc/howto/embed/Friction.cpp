#include "Friction.hpp"

#include "bem/quadrature/Gauss.hpp"
#include "contact/equation/Classify.hpp"
#include "contact/nox/ContactModel.hpp"
#include "contact/nox/NoxNewton.hpp"
#include "contact/solve/CoulombIteration.hpp"

#include <NOX.H>
#include <NOX_Thyra.H>
#include <Thyra_TpetraThyraWrappers.hpp>

#include <LOCA.H>
#include <LOCA_Thyra.H>
#include <algorithm>
#include <cmath>

namespace embed {

namespace bem = epafi::bem;
namespace contact = epafi::contact;
using contact::ContactModel;
using Teuchos::ParameterList;
using Teuchos::RCP;
using Teuchos::rcp;

namespace {

constexpr double first = 0.1;
constexpr double last = 2;

// Newton's method by NOX, the stages of a solve on it, Coulomb's iteration on that.
contact::State solved(const contact::Problem& problem) {
  const contact::NoxNewton newton;
  const contact::ContactSolver solver(newton);
  return contact::makeCoulomb(solver, {})->solve(problem, {}).state;
}

// Each coefficient stands for its Gauss point's share of the element.
Point measure(const Block& block, const contact::ContactSystem& system,
              const ContactModel& model, double factor, const contact::State& state) {
  const contact::Problem numbers = model.family().at({1, factor});
  const contact::ContactStates states =
      classify(numbers, state, penetration(numbers, state));
  Point point{factor, 0, 0, 0};
  for (const auto& element : system.body(0).elements()) {
    const auto& weights = bem::gaussLegendre(element.degree + 1).weights;
    const double half = block.units.length * block.space.mesh()[element.element].half;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const auto k = static_cast<std::size_t>(element.tangential.first) + i;
      if (slips(states[k]))
        point.slipLength += half * weights[i];
      point.shear +=
          half * weights[i] * block.units.stress * std::abs(state.multiplier[k]);
    }
  }
  const contact::State direct = solved(numbers);
  for (std::size_t i = 0; i < direct.multiplier.size(); ++i)
    point.difference =
        std::max(point.difference, std::abs(direct.multiplier[i] - state.multiplier[i]));
  point.difference /= numbers.stress;
  return point;
}

// LOCA hands each solution to this.
class Recorder final : public LOCA::Thyra::SaveDataStrategy {
 public:
  explicit Recorder(RCP<const ContactModel> model) : model_(std::move(model)) {}

  void saveSolution(const NOX::Abstract::Vector& x, double factor) override {
    const auto& vector = Teuchos::dyn_cast<const NOX::Thyra::Vector>(x);
    path.emplace_back(factor, model_->state(vector.getThyraVector()));
  }

  std::vector<std::pair<double, contact::State>> path;

 private:
  RCP<const ContactModel> model_;
};

RCP<ParameterList> parameters() {
  const auto list = Teuchos::parameterList();
  ParameterList& nox = list->sublist("NOX");
  nox.sublist("Line Search").set("Method", "Full Step");
  nox.sublist("Printing").set("Output Information", 0);
  ParameterList& loca = list->sublist("LOCA");
  loca.sublist("Stepper")
      .set("Continuation Method", "Natural")
      .set("Continuation Parameter", "Friction Factor")
      .set("Initial Value", first)
      .set("Min Value", first)
      .set("Max Value", last)
      .set("Max Steps", 100)
      .set("Max Nonlinear Iterations", 20)
      .set("Compute Eigenvalues", false);
  loca.sublist("Predictor").set("Method", "Tangent");
  loca.sublist("Step Size").set("Method", "Constant").set("Initial Step Size", 0.19);
  return list;
}

}  // namespace

std::vector<Point> followFriction(const Block& block,
                                  const bem::MpiProcesses& processes) {
  const contact::Conditions conditions = pressed();
  const contact::MultiplierBasis& basis =
      contact::multiplierBasis("Gauss-Legendre-Lagrange");
  const contact::Stabilization stabilization;
  // the stabilisation has a say in the densities and in S
  const bem::Space space =
      contact::makeSpace(block.space.mesh(), conditions, stabilization);
  const bem::SteklovPoincare stiffness =
      contact::makeStiffness(space, conditions, stabilization, block.lame, block.units);
  const contact::ContactSystem system(
      {{space, stiffness, block.lame, block.units, conditions, basis, stabilization}});

  ContactModel::Options options;
  options.space = Thyra::createVectorSpace<double>(
      processes.rowMap(ContactModel::unknowns(system.numbers())));
  const auto model = rcp(new ContactModel(system, options));

  const auto norm =
      rcp(new NOX::StatusTest::NormF(1e-11, NOX::StatusTest::NormF::Unscaled));
  const auto steps = rcp(new NOX::StatusTest::MaxIters(20));
  const auto test =
      rcp(new NOX::StatusTest::Combo(NOX::StatusTest::Combo::OR, norm, steps));

  const auto start = model->point(solved(model->family().at({1, first})));
  const RCP<ParameterList> list = parameters();
  const RCP<LOCA::GlobalData> data = LOCA::createGlobalData(list);
  const auto recorder = rcp(new Recorder(model));
  LOCA::Abstract::Iterator::IteratorStatus status;
  {
    LOCA::ParameterVector factor;
    factor.addParameter("Friction Factor", first);
    const auto group = rcp(new LOCA::Thyra::Group(data, NOX::Thyra::Vector(start), model,
                                                  factor, ContactModel::Friction));
    group->setSaveDataStrategy(recorder);
    LOCA::Stepper stepper(data, group, test, list);
    status = stepper.run();
  }
  LOCA::destroyGlobalData(data);
  if (status != LOCA::Abstract::Iterator::Finished)
    throw std::runtime_error("LOCA has not reached the last friction factor");

  std::vector<Point> points;
  for (const auto& [factor, state] : recorder->path)
    points.push_back(measure(block, system, *model, factor, state));
  return points;
}

}  // namespace embed
