#include "drivers/scene/Options.hpp"

#include "drivers/process/Ranks.hpp"

#include <Teuchos_ParameterList.hpp>

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

}  // namespace epafi::drivers
