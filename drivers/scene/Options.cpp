#include "drivers/scene/Options.hpp"

#include "bem/base/Error.hpp"
#include "drivers/process/Ranks.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>

#include <numeric>

namespace epafi::drivers {

namespace {

using Solver = std::unique_ptr<const bem::SingleLayerSolver>;

Solver factors(const Ranks&, const LinearOptions&) { return nullptr; }

Solver belos(const Ranks& ranks, const LinearOptions& options) {
  return ranks.belosSolver(options.belos);
}

}  // namespace

bem::Family<LinearMethod>& linearMethods() {
  static bem::Family<LinearMethod> family(
      "linear method",
      {
          {"Dense", "Cholesky's factors", factors},
          {"Belos", "conjugate gradients, for each column", belos,
           LinearMethod::Operators::Dense, false},
          {"Compressed",
           "by skeletons, time and memory nearly proportional to the elements; "
           "Stabilization->Form Density or None",
           factors, LinearMethod::Operators::Compressed},
          {"Automatic",
           "Compressed where that is possible, from 3100 displacements and densities of "
           "one body on, later where bodies meet, on meshes graded by less than 1e6 of "
           "bodies that are not slender; else Dense; never changes Stabilization->Form",
           factors, LinearMethod::Operators::Cheaper},
      });
  return family;
}

void LinearOptions::keys(bem::Keys& keys) {
  keys.add(&method, "Method", linearMethods(),
           "how systems with the boundary operators are solved; ");
  belos.keys(keys);
  keys.add(&compression.tolerance, "Compression Tolerance", "1", {1e-13, 1e-4},
           "Compressed: of what groups of elements do to others");
}

void SolverOptions::keys(bem::Keys& keys) {
  coulomb.keys(keys);
  contact.keys(keys);
}

SolverOptions parseSolver(const Teuchos::ParameterList& list) {
  auto solver = bem::parsed<SolverOptions>(list);
  solver.linear = bem::parsed<LinearOptions>(list.sublist("Linear"));
  if (list.isSublist("NOX") && list.sublist("NOX").numParams() > 0) {
    const auto nox = std::make_shared<Teuchos::ParameterList>(list.sublist("NOX"));
    nox->setName("Solver->NOX");
    solver.nox = nox;
  }
  return solver;
}

namespace {

using bem::InputError;

constexpr double mostSteps = 100000;

/// The number of steps up to each time.
std::vector<int> stepsOf(const Teuchos::ParameterList& list, std::size_t times) {
  if (!list.isParameter("Steps"))
    return std::vector<int>(times, 1);
  std::vector<int> steps = list.get<Teuchos::Array<int>>("Steps").toVector();
  if (steps.size() == 1)
    steps.resize(times, steps.front());
  if (steps.size() != times)
    throw InputError("History->Steps: has ", steps.size(),
                     " numbers, but History->Times has ", times,
                     "; give one for all or one for each");
  if (std::accumulate(steps.begin(), steps.end(), 0.0) > mostSteps)
    throw InputError("History->Steps: more than ", mostSteps, " steps");
  return steps;
}

/// With a tolerance the shortest step must allow `fewestSteps` steps up to each time.
void requireShortSteps(const History& history) {
  double start = 0;
  for (const double end : history.times) {
    const double most = (end - start) / History::fewestSteps;
    if (history.tolerance > 0 && history.shortest(end - start) > (1 + 1e-9) * most)
      throw InputError("History->Minimum Step = ", history.minimumStep,
                       ": a Tolerance takes at least ", History::fewestSteps,
                       " steps from t = ", start, " to ", end, "; at most ", most);
    start = end;
  }
}

}  // namespace

bem::SchemaRows historyRows() {
  using bem::Kind;
  using bem::Row;
  return {
      Row("Times", Kind::Reals, "that of t in the expressions", bem::above(0),
          "the path starts unloaded at t = 0 and is solved up to each of these, in this "
          "order; expressions know t"),
      Row("Steps", Kind::Counts, "1", {1, mostSteps},
          "equal steps up to each time, one number for all or one for each; without it "
          "one"),
      Row("Minimum Step", Kind::Real, "that of t in the expressions", bem::above(0),
          "a step that fails is halved down to this; without it to 1/64 of the step, to "
          "1/1024 under a Tolerance, which needs at least 1/8"),
      Row("Tolerance", Kind::Real, "1", {0, 1, false, true},
          "error in time of friction's work, relative: chooses how many steps are solved "
          "up to each time that Times and Steps ask for; without it, or if 0, one"),
  };
}

History parseHistory(const Teuchos::ParameterList& list) {
  History history;
  if (!list.isParameter("Times")) {
    if (list.numParams() > 0)
      throw InputError("History->Times: missing; History->", list.begin()->first,
                       " says nothing without it");
    return history;
  }
  const auto& times = list.get<Teuchos::Array<double>>("Times");
  if (times.size() == 0)
    throw InputError("History->Times: is empty; at least one time is needed");
  const std::vector<int> steps = stepsOf(list, static_cast<std::size_t>(times.size()));
  history = {true, {}};
  double start = 0;
  for (int k = 0; k < times.size(); ++k) {
    const double end = times[k];
    if (!(end > start))
      throw InputError("History->Times: number ", k, " = ", end,
                       " is not above the one before, ", start, "; times increase");
    const int count = steps[k];
    for (int i = 1; i < count; ++i)
      history.times.push_back(start + (end - start) * i / count);
    history.times.push_back(end);
    start = end;
  }
  if (list.isParameter("Minimum Step"))
    history.minimumStep = list.get<double>("Minimum Step");
  if (list.isParameter("Tolerance"))
    history.tolerance = list.get<double>("Tolerance");
  requireShortSteps(history);
  return history;
}

}  // namespace epafi::drivers
