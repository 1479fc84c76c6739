#pragma once

#include "bem/base/Family.hpp"
#include "bem/base/Keys.hpp"
#include "contact/solve/ContactSolver.hpp"

#include <memory>
#include <string>
#include <utility>

namespace epafi::contact {

/// Options of the iteration for a slip bound that depends on the pressure.
struct CoulombOptions {
  std::string iteration = "Newton";  ///< a name of coulombIterations()
  double tolerance = 1e-10;          ///< for the change of the bound relative to the load
  int maximumIterations = 100;       ///< updates of the bound

  void keys(bem::Keys& keys);
};

/// Solves problems whose slip bound depends on the pressure.
class CoulombSolver : public NonlinearSolver {
 public:
  /// `solver` must outlive this.
  explicit CoulombSolver(const ContactSolver& solver, CoulombOptions options = {})
      : solver_(solver), options_(std::move(options)) {}

 protected:
  const ContactSolver& solver_;
  CoulombOptions options_;
};

/// A method for problems whose slip bound depends on the pressure; its solvers refer to the
/// ContactSolver.
struct CoulombIteration {
  const char* name;
  const char* meaning;
  std::unique_ptr<NonlinearSolver> (*make)(const ContactSolver& solver,
                                           const CoulombOptions& options);
};

/// All iterations; a program may add others before it reads its first scene.
bem::Family<CoulombIteration>& coulombIterations();

/// The solver named by the options.
std::unique_ptr<NonlinearSolver> makeCoulomb(const ContactSolver& solver,
                                             const CoulombOptions& options);

}  // namespace epafi::contact
