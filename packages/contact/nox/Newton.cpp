#include "contact/nox/Newton.hpp"

#include "bem/base/Error.hpp"
#include "contact/nox/ArmijoSearch.hpp"
#include "contact/nox/Group.hpp"
#include "contact/nox/Merit.hpp"
#include "contact/nox/PivotingDirection.hpp"
#include "contact/nox/StatusTests.hpp"
#include "contact/solve/Equilibrium.hpp"
#include "contact/solve/NewtonSystem.hpp"

#include <NOX_Solver_Factory.H>
#include <NOX_Solver_Generic.H>
#include <NOX_StatusTest_Combo.H>
#include <NOX_StatusTest_MaxIters.H>
#include <Teuchos_ParameterList.hpp>

#include <sstream>

namespace epafi::contact {

namespace {

using Teuchos::ParameterList;
using Teuchos::RCP;
using Teuchos::rcp;

// What the user wrote and NOX never asked for, as A->B->Key.
std::string firstUnused(const ParameterList& user, const ParameterList& run,
                        const std::string& path) {
  for (auto it = user.begin(); it != user.end(); ++it) {
    const std::string& key = user.name(it);
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

// Adds what NOX filled in, marked as a default so that it never counts as the user's own.
void addDefaults(ParameterList& user, const ParameterList& run) {
  for (auto it = run.begin(); it != run.end(); ++it) {
    const std::string& key = run.name(it);
    if (run.isSublist(key)) {
      addDefaults(user.sublist(key), run.sublist(key));
    } else if (!user.isParameter(key)) {
      Teuchos::ParameterEntry entry;
      entry.setAnyValue(run.entry(it).getAny(false), true);
      user.setEntry(key, entry);
    }
  }
}

bool isUsersOwn(const ParameterList& list, const char* sublist, const char* key) {
  return list.isSublist(sublist) && list.sublist(sublist).isParameter(key);
}

// One run's list: the user's, and below it what Epafi wants of NOX.
class RunList {
 public:
  RunList(std::shared_ptr<ParameterList> user, NewtonMethod method,
          const RCP<std::ostream>& errors)
      : user_(std::move(user)), list_(rcp(new ParameterList("NOX"))) {
    if (user_ != nullptr) {
      user_->remove("Output", false);  // NOX's own record of an earlier run
      list_->setParameters(*user_);
      forgetUse(*list_);
    }
    const RCP<const Merit> merit = rcp(new Merit);
    const std::string solver = list_->get("Nonlinear Solver", "Line Search Based");
    if (solver != "Line Search Based")
      throw bem::InputError(bem::message("Solver->NOX->Nonlinear Solver = '", solver,
                                         "'; allowed: 'Line Search Based'"));
    list_->sublist("Solver Options")
        .set<RCP<NOX::MeritFunction::Generic>>("User Defined Merit Function",
                                               Teuchos::rcp_const_cast<Merit>(merit));
    ParameterList& newton = list_->sublist("Direction").sublist("Newton");
    if (!newton.isParameter("Rescue Bad Newton Solve"))
      newton.set("Rescue Bad Newton Solve", false);
    if (!isUsersOwn(*list_, "Printing", "Output Information"))
      list_->sublist("Printing")
          .set("Output Information", 0)
          .set("Output Stream", errors);  // some of it comes whatever the information
    list_->sublist("Printing").set("Error Stream", errors);
    if (method == NewtonMethod::Pivoting) {
      ParameterList& direction = list_->sublist("Direction");
      direction.set("Method", "User Defined");
      direction.set<RCP<NOX::Direction::UserDefinedFactory>>(
          "User Defined Direction Factory", rcp(new PivotingFactory));
    }
    if (method == NewtonMethod::MeritDescent) {
      ParameterList& search = list_->sublist("Line Search");
      search = ParameterList("Line Search");
      search.set("Method", "User Defined");
      search.set<RCP<NOX::LineSearch::UserDefinedFactory>>(
          "User Defined Line Search Factory", rcp(new ArmijoFactory(merit)));
    } else if (!isUsersOwn(*list_, "Line Search", "Method")) {
      list_->sublist("Line Search").set("Method", "Full Step");
    }
  }

  const RCP<ParameterList>& list() const { return list_; }

  /// Hands what NOX filled in back to the user's list.
  /// \throws bem::InputError naming what was never used.
  void finish(NewtonMethod method) {
    if (user_ == nullptr || method != NewtonMethod::Newton)
      return;
    const std::string unused = firstUnused(*user_, *list_, "Solver->NOX");
    if (!unused.empty())
      throw bem::InputError(
          bem::message(unused, ": NOX does not know or use this parameter"));
    list_->sublist("Solver Options").remove("User Defined Merit Function");
    list_->sublist("Printing").remove("Output Stream", false);
    list_->sublist("Printing").remove("Error Stream");
    list_->remove("Output", false);
    addDefaults(*user_, *list_);
  }

 private:
  // Copies carry the flag "used"; each run asks anew.
  static void forgetUse(ParameterList& list) {
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

  std::shared_ptr<ParameterList> user_;
  RCP<ParameterList> list_;
};

RCP<NOX::Solver::Generic> build(const RCP<Group>& group, const RCP<StepTest>& test,
                                int maximumIterations, const RCP<ParameterList>& list) {
  const auto limit = rcp(new NOX::StatusTest::MaxIters(std::max(maximumIterations, 1)));
  const auto tests =
      rcp(new NOX::StatusTest::Combo(NOX::StatusTest::Combo::OR, test, limit));
  return NOX::Solver::buildSolver(group, tests, list);
}

// NOX throws literals and logic errors where a parameter is wrong.
template <class Action>
auto withNoxErrors(const std::ostringstream& log, const Action& action) {
  try {
    return action();
  } catch (const bem::InputError&) {
    throw;
  } catch (const std::logic_error& error) {
    throw bem::InputError(bem::message("Solver->NOX: ", error.what()));
  } catch (const char* text) {
    throw bem::InputError(bem::message("Solver->NOX: ", text, ": ", log.str()));
  }
}

}  // namespace

bool hasOwnEntries(const ParameterList& list) {
  for (auto it = list.begin(); it != list.end(); ++it) {
    const std::string& key = list.name(it);
    if (list.isSublist(key) ? hasOwnEntries(list.sublist(key))
                            : !list.entry(it).isDefault())
      return true;
  }
  return false;
}

NewtonRun runNewton(const Equation& equation, const Vector& start, NewtonMethod method,
                    int maximumIterations, const std::shared_ptr<ParameterList>& list) {
  const auto log = rcp(new std::ostringstream);
  RunList run(list, method, log);
  const auto group = rcp(new Group(equation, method, start));
  // With a lagged bound the residual may rise for a step while the bound settles.
  const int patience = equation.bound() == Equation::Bound::Lagged ? 5 : 1;
  const auto test = rcp(new StepTest(method, patience));
  const RCP<NOX::Solver::Generic> solver = withNoxErrors(
      *log, [&] { return build(group, test, maximumIterations, run.list()); });

  const RCP<const Merit> merit = rcp(new Merit);
  const bool descends = method == NewtonMethod::MeritDescent;
  std::vector<double> merits;
  NewtonRun result;
  const auto status = withNoxErrors(*log, [&] {
    auto now = solver->getStatus();
    while (now == NOX::StatusTest::Unconverged || now == NOX::StatusTest::Unevaluated) {
      if (descends)
        merits.push_back(merit->computef(solver->getSolutionGroup()));
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
    if (descends)
      merits.push_back(merit->computef(solver->getSolutionGroup()));
    return now;
  });

  const std::string message = result.message;
  const bool unbalanced = result.end == End::NoBalance;
  result = test->history();
  result.message = message;
  result.iterations = solver->getNumIterations();
  result.merits = std::move(merits);
  if (!message.empty())
    result.end = unbalanced ? End::NoBalance : End::Singular;
  else if (status == NOX::StatusTest::Failed && result.end == End::Iterations &&
           result.iterations < maximumIterations)
    result.end = End::Stalled;
  run.finish(method);
  return result;
}

}  // namespace epafi::contact
