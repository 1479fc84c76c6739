#pragma once

#include <sstream>
#include <stdexcept>
#include <string>

namespace epafi::bem {

/// Joins its arguments into one string: message("p = ", 0, " must be positive").
template <class... Part>
std::string message(const Part&... part) {
  std::ostringstream text;
  (text << ... << part);
  return text.str();
}

/// The scene asks for something impossible; the message, joined from parts, names the
/// parameter.  Exit code 1.
struct InputError : std::invalid_argument {
  template <class... Part>
  explicit InputError(const Part&... part) : std::invalid_argument(message(part...)) {}
};

/// Arithmetic broke down (indefinite matrix, NaN).  Exit code 2.  Slow convergence is no
/// error: it is reported by value, see contact::Report.
struct NumericalError : std::runtime_error {
  template <class... Part>
  explicit NumericalError(const Part&... part) : std::runtime_error(message(part...)) {}
};

}  // namespace epafi::bem
