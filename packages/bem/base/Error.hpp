#pragma once

#include <sstream>
#include <stdexcept>
#include <string>

namespace epafi::bem {

/// The scene asks for something impossible; the message names the parameter.  Exit
/// code 1.
struct InputError : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// Arithmetic broke down (indefinite matrix, NaN).  Exit code 2.  Slow convergence is no
/// error: it is reported by value, see contact::Report.
struct NumericalError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Joins its arguments into one string: message("p = ", 0, " must be positive").
template <class... Part>
std::string message(const Part&... part) {
  std::ostringstream text;
  (text << ... << part);
  return text.str();
}

}  // namespace epafi::bem
