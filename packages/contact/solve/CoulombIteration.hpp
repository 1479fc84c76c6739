#pragma once

#include "bem/base/Family.hpp"
#include "contact/solve/ContactSolver.hpp"

#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace epafi::contact {

/// Options of the Tresca problems of a Fixed Point; what is empty is as for the ContactSolver.
struct TrescaOptions {
  std::optional<double> tolerance;
  std::optional<int> maximumIterations;

  void keys(bem::Keys& keys);
};

/// Options of the iteration for a slip bound that depends on the pressure.
struct CoulombOptions {
  std::string iteration = "Newton";  ///< a name of coulombIterations()
  double tolerance = 1e-10;          ///< for the change of the bound relative to the load
  int maximumIterations = 100;       ///< updates of the bound
  TrescaOptions tresca;

  void keys(bem::Keys& keys);
};

/// Solves problems whose slip bound depends on the pressure.
class CoulombSolver : public NonlinearSolver, public bem::Acceptor<CoulombOptions> {
 public:
  /// `solver` must outlive this.
  explicit CoulombSolver(const ContactSolver& solver, CoulombOptions options = {})
      : Acceptor(std::move(options)), solver_(solver) {}

  /// \throws bem::InputError also if the list names another iteration
  void setParameterList(const Teuchos::RCP<Teuchos::ParameterList>& list) final;

 protected:
  const ContactSolver& solver_;
};

/// A method for problems whose slip bound depends on the pressure; its solvers refer to the
/// ContactSolver.
struct CoulombIteration {
  const char* name;
  const char* meaning;
  std::unique_ptr<CoulombSolver> (*make)(const ContactSolver& solver,
                                         const CoulombOptions& options);
};

/// All iterations; a program may add others before it reads its first scene.
bem::Family<CoulombIteration>& coulombIterations();

/// The solver named by the options, or by a list of their keys, which is completed.
/// \throws bem::InputError as bem::Acceptor::setParameterList
std::unique_ptr<CoulombSolver> makeCoulomb(const ContactSolver& solver,
                                           const CoulombOptions& options);
std::unique_ptr<CoulombSolver> coulombFromList(
    const ContactSolver& solver, const Teuchos::RCP<Teuchos::ParameterList>& list);

}  // namespace epafi::contact
