#include "contact/nox/NoxNewton.hpp"

#include "bem/base/Error.hpp"
#include "contact/equation/Equilibrium.hpp"
#include "contact/nox/ContactJacobian.hpp"
#include "contact/nox/StatusTests.hpp"

#include <NOX_MeritFunction_Generic.H>
#include <NOX_Solver_Factory.H>
#include <NOX_Solver_Generic.H>
#include <NOX_StatusTest_Combo.H>
#include <NOX_StatusTest_Factory.H>
#include <NOX_StatusTest_MaxIters.H>
#include <NOX_Thyra_Group.H>
#include <NOX_Thyra_Vector.H>
#include <NOX_Utils.H>
#include <Teuchos_ParameterList.hpp>
#include <Thyra_BelosLinearOpWithSolveFactory.hpp>

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace epafi::contact {

namespace {

using Teuchos::ParameterList;
using Teuchos::RCP;
using Teuchos::rcp;

/// Ψ = ½ |F|² with the Fischer-Burmeister function, see merit(), for NOX's line searches.
///
/// Ψ is continuously differentiable where the slip bound is; ½ |F|² of Equation is not.
///                                                       [De Luca, Facchinei, Kanzow 1996]
class Merit final : public NOX::MeritFunction::Generic {
 public:
  explicit Merit(RCP<const ContactModel> model) : model_(std::move(model)) {}

  double computef(const NOX::Abstract::Group& group) const override {
    const auto point = model_->at(group);
    return merit(point->equation(), point->evaluation());
  }
  void computeGradient(const NOX::Abstract::Group& group,
                       NOX::Abstract::Vector& result) const override {
    const auto point = model_->at(group);
    auto& vector = dynamic_cast<NOX::Thyra::Vector&>(result).getThyraVector();
    scatter(dynamic_cast<const SpmdSpace&>(*vector.space()),
            meritGradient(point->equation(), point->evaluation()), 1, 0, vector);
  }
  double computeSlope(const NOX::Abstract::Vector& direction,
                      const NOX::Abstract::Group& group) const override {
    const auto gradient = direction.clone(NOX::ShapeCopy);
    computeGradient(group, *gradient);
    return gradient->innerProduct(direction);
  }
  double computeQuadraticModel(const NOX::Abstract::Vector&,
                               const NOX::Abstract::Group&) const override {
    throw std::logic_error("only trust regions use a quadratic model");
  }
  void computeQuadraticMinimizer(const NOX::Abstract::Group&,
                                 NOX::Abstract::Vector&) const override {
    throw std::logic_error("only trust regions use a quadratic model");
  }
  const std::string& name() const override { return name_; }

 private:
  RCP<const ContactModel> model_;
  std::string name_ = "half the squared Fischer-Burmeister residual";
};

constexpr char statusTests[] = "Status Tests";
constexpr char linearSolver[] = "Stratimikos Linear Solver";

// The first key of the user that NOX did not read, as A->B->Key.
std::string firstUnused(const ParameterList& user, const ParameterList& run,
                        const std::string& path) {
  for (auto it = user.begin(); it != user.end(); ++it) {
    const std::string& key = user.name(it);
    if (key == linearSolver)
      continue;  // Stratimikos checks its list by itself
    if (user.isSublist(key) && run.isSublist(key)) {
      std::string inner =
          firstUnused(user.sublist(key), run.sublist(key), bem::message(path, "->", key));
      if (!inner.empty())
        return inner;
    } else if (!user.entry(it).isDefault() &&
               (!run.isParameter(key) || !run.getEntry(key).isUsed())) {
      return bem::message(path, "->", key);
    }
  }
  return "";
}

std::string nameOf(const ParameterList* user) {
  return user != nullptr ? user->name() : "NOX";
}

bool isUsersOwn(const ParameterList& list, const char* sublist, const char* key) {
  return list.isSublist(sublist) && list.sublist(sublist).isParameter(key);
}

// Resets the flag "used", which copies of lists keep.
void forgetUse(ParameterList& list) {
  ParameterList fresh(list.name());
  for (auto it = list.begin(); it != list.end(); ++it) {
    const std::string key = list.name(it);
    if (list.isSublist(key)) {
      forgetUse(list.sublist(key));
      fresh.sublist(key) = list.sublist(key);
    } else {
      Teuchos::ParameterEntry entry;
      entry.setAnyValue(list.entry(it).getAny(false), list.entry(it).isDefault());
      fresh.setEntry(key, entry);
    }
  }
  list = fresh;
}

// A key that NOX has more values for than go with Epafi's model, and why.
void requireOneOf(const ParameterList& list, const std::string& sublist,
                  const std::string& key, const std::vector<std::string>& allowed,
                  const char* because) {
  if (!sublist.empty() && !list.isSublist(sublist))
    return;
  const ParameterList& holder = sublist.empty() ? list : list.sublist(sublist);
  if (!holder.isType<std::string>(key))
    return;
  const auto& value = holder.get<std::string>(key);
  if (std::find(allowed.begin(), allowed.end(), value) != allowed.end())
    return;
  std::string names;
  for (const std::string& name : allowed)
    names += (names.empty() ? "'" : ", '") + name + "'";
  throw bem::InputError(list.name(), sublist.empty() ? "" : "->", sublist, "->", key,
                        " = '", value, "'; allowed: ", names, "; ", because);
}

// What Teuchos says, without the place in its sources and the condition.
std::string saidBy(const std::logic_error& error) {
  const std::string what = error.what();
  const std::string text = what.substr(0, what.find("\n\nThrow number"));
  const auto condition = text.find("Throw test that evaluated to true");
  const auto end =
      condition == std::string::npos ? condition : text.find("\n\n", condition);
  return end == std::string::npos ? text : text.substr(end + 2);
}

// List for one run: that of the user, completed by the defaults of Epafi.
RCP<ParameterList> runList(const ParameterList* user, const RCP<ContactModel>& model,
                           const RCP<std::ostream>& log) {
  const auto list = rcp(new ParameterList(nameOf(user)));
  if (user != nullptr) {
    list->setParameters(*user);
    forgetUse(*list);
  }
  requireOneOf(*list, "", "Nonlinear Solver", {"Line Search Based"},
               "trust regions measure a step by one norm, but its parts are stresses and "
               "motions, and they predict it by a smooth Jacobian");
  requireOneOf(*list, "Line Search", "Method",
               {"Full Step", "Backtrack", "Polynomial", "NonlinearCG", "User Defined"},
               "other methods take slopes from the residual, which has kinks");
  list->sublist("Solver Options")
      .set<RCP<NOX::MeritFunction::Generic>>("User Defined Merit Function",
                                             rcp(new Merit(model)));
  if (!isUsersOwn(*list, "Printing", "Output Information"))
    list->sublist("Printing")
        .set("Output Information", 0)
        .set("Output Stream",
             log);  // NOX prints some of it whatever Output Information says
  list->sublist("Printing").set("Error Stream", log);

  if (!isUsersOwn(*list, "Line Search", "Method"))
    list->sublist("Line Search").set("Method", "Full Step");
  return list;
}

/// Newton's systems by products with the Jacobian, if the list asks for it.
RCP<NOX::Abstract::Group> makeGroup(const RCP<ContactModel>& model, const Vector& start,
                                    ParameterList& list) {
  const NOX::Thyra::Vector x(*model->vector(start));
  ParameterList& newton = list.sublist("Direction").sublist("Newton");
  if (!newton.isSublist(linearSolver))
    return rcp(new NOX::Thyra::Group(x, model));
  ParameterList stratimikos = newton.sublist(linearSolver).sublist("Stratimikos");
  stratimikos.setName(
      bem::message(list.name(), "->Direction->Newton->", linearSolver, "->Stratimikos"));
  requireOneOf(stratimikos, "", "Linear Solver Type", {"Belos"},
               "others need the entries of the Jacobian");
  const auto factory = rcp(new Thyra::BelosLinearOpWithSolveFactory<double>);
  factory->setParameterList(rcp(
      new ParameterList(stratimikos.sublist("Linear Solver Types").sublist("Belos"))));
  const RCP<Thyra::PreconditionerBase<double>> none;
  const RCP<Thyra::PreconditionerFactoryBase<double>> noFactory;
  return rcp(
      new NOX::Thyra::Group(x, model, model->create_W_op(), factory, none, noFactory));
}

RCP<NOX::Solver::Generic> build(const RCP<NOX::Abstract::Group>& group,
                                const RCP<StepTest>& test, int maximumIterations,
                                const RCP<ParameterList>& list) {
  const auto limit = rcp(new NOX::StatusTest::MaxIters(std::max(maximumIterations, 1)));
  const auto tests =
      rcp(new NOX::StatusTest::Combo(NOX::StatusTest::Combo::OR, test, limit));
  if (list->isSublist(statusTests))
    tests->addStatusTest(NOX::StatusTest::buildStatusTests(
        list->sublist(statusTests), NOX::Utils(list->sublist("Printing"))));
  return NOX::Solver::buildSolver(group, tests, list);
}

// NOX throws string literals and std::logic_error for wrong parameters.
template <class Action>
auto withNoxErrors(const std::string& list, const std::ostringstream& log,
                   const Action& action) {
  try {
    return action();
  } catch (const bem::InputError&) {
    throw;
  } catch (const std::logic_error& error) {
    throw bem::InputError(list, ": ", saidBy(error));
  } catch (const char* text) {
    throw bem::InputError(list, ": ", text, ": ", log.str());
  }
}

}  // namespace

bem::SchemaRow noxRow() {
  return bem::Row("NOX", bem::Kind::Free,
                  "handed to NOX; empty means Epafi's own choice");
}

NewtonRun NoxNewton::run(const Equation& equation, const Vector& start,
                         int maximumIterations) const {
  const auto log = rcp(new std::ostringstream);
  const auto model = rcp(new ContactModel(equation));
  const auto list = runList(list_.get(), model, log);
  // With a lagged bound the residual may grow for a step while the bound converges.  A load comes
  // from body to body, a step for each, before the residual falls.
  constexpr Index fewest = 12;
  const StepTest::Patience patience{
      equation.bound() == Equation::Bound::Lagged ? 5 : 1,
      static_cast<std::size_t>(std::max(fewest, equation.problem().rigidMotions()))};
  const auto test = rcp(new StepTest(model, patience));
  const RCP<NOX::Solver::Generic> solver = withNoxErrors(list->name(), *log, [&] {
    return build(makeGroup(model, start, *list), test, maximumIterations, list);
  });

  NewtonRun result;
  const auto status = withNoxErrors(list->name(), *log, [&] {
    auto now = solver->getStatus();
    while (now == NOX::StatusTest::Unconverged || now == NOX::StatusTest::Unevaluated) {
      try {
        now = solver->step();
      } catch (const SingularJacobian& error) {
        result.message = error.what();
        return NOX::StatusTest::Failed;
      } catch (const NoBalance& error) {
        result.message = error.what();
        result.end = End::NoBalance;
        return NOX::StatusTest::Failed;
      }
    }
    return now;
  });

  const std::string message = result.message;
  const bool unbalanced = result.end == End::NoBalance;
  result = test->history();
  result.message = message;
  result.iterations = solver->getNumIterations();
  if (!message.empty())
    result.end = unbalanced ? End::NoBalance : End::Singular;
  else if (status == NOX::StatusTest::Converged && result.end != End::Converged)
    result.end = End::Converged,
    result.tolerance = result.residual;  // by the user's tests
  else if (status == NOX::StatusTest::Failed && result.end == End::Iterations &&
           result.iterations < maximumIterations)
    result.end = End::Stalled;
  const std::string unused =
      list_ != nullptr ? firstUnused(*list_, *list, list_->name()) : "";
  if (!unused.empty())
    throw bem::InputError(unused, ": NOX does not know or use this parameter");
  return result;
}

}  // namespace epafi::contact
