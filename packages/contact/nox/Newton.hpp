#pragma once

#include "contact/equation/Equation.hpp"
#include "contact/solve/Report.hpp"

#include <memory>
#include <string>
#include <vector>

namespace Teuchos {
class ParameterList;
}

namespace epafi::contact {

/// How one run of Newton's method chooses and shortens its steps.
enum class NewtonMethod {
  /// Newton's steps, full ones unless NOX's list asks for a line search.
  Newton,
  /// The same from a start that knows the active sets but for a few coefficients, such as
  /// the state of a coarser mesh: see Pivoting.  Only with active sets.
  Pivoting,
  /// Armijo's rule on ½|F|²; the equation's function must have a smooth merit function.
  MeritDescent
};

/// What one run of Newton's method did.
struct NewtonRun {
  End end = End::Iterations;
  int iterations = 0;  ///< linear systems solved
  Vector last;
  Vector best;  ///< the iterate with the least residual
  double residual = 0;
  double tolerance = 0;
  std::vector<int> setChanges;
  std::vector<Index> restless;  ///< coefficients that changed in the last steps
  std::vector<double> merits;   ///< of the start and after each step of a descent
  std::string message;          ///< of a singular Jacobian
};

/// Runs NOX on F(x) = 0 from `start`.
///
/// The list acts whatever the method: what it says of Direction, Line Search and Printing
/// replaces the method's own choice.  Null: full steps (a line search under MeritDescent),
/// nothing printed.
/// \throws bem::InputError for what NOX refuses in the list, or does not use of it.
NewtonRun runNewton(const Equation& equation, const Vector& start, NewtonMethod method,
                    int maximumIterations,
                    const std::shared_ptr<const Teuchos::ParameterList>& list = nullptr);

}  // namespace epafi::contact
