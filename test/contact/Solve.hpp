#pragma once

#include "contact/equation/Classify.hpp"
#include "contact/equation/Equation.hpp"
#include "contact/nox/NoxNewton.hpp"
#include "contact/solve/ContactSolver.hpp"
#include "contact/solve/CoulombIteration.hpp"

#include <memory>

namespace epafi::test {

/// A solver of any problem, assembled as a program does it.
struct SolverOptions {
  contact::ContactSolverOptions contact;
  contact::CoulombOptions coulomb;
  std::shared_ptr<const Teuchos::ParameterList> nox;
};

inline contact::Solution solve(const contact::Problem& problem,
                               const contact::State& start = {},
                               const SolverOptions& options = {}) {
  const contact::NoxNewton newton(options.nox);
  const contact::ContactSolver fixed(newton, options.contact);
  const auto coulomb = makeCoulomb(fixed, options.coulomb);
  const contact::NonlinearSolver* solver = &fixed;
  if (problem.boundDependsOnPressure())
    solver = coulomb.get();
  return solver->solve(problem, start);
}

/// Bounds with their slopes.
inline contact::Equation equationOf(const contact::Problem& problem,
                                    double tolerance = 1e-12) {
  return {problem, contact::Equation::Bound::Differentiated, tolerance};
}

/// rₜ at a state: the slip weighted by the multiplier's functions, stabilisation included.
inline contact::Vector slip(const contact::Problem& problem,
                            const contact::State& state) {
  const contact::Vector r = contact::penetration(problem, state);
  return {r.begin() + problem.normals, r.end()};
}

/// What each coefficient does, by D.
inline contact::ContactStates statesOf(const contact::Problem& problem,
                                       const contact::State& state) {
  return classify(problem, state, contact::penetration(problem, state));
}

}  // namespace epafi::test
