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

/// Invalid input in the scene; the message, joined from parts, names the parameter.  Exit
/// code 1.
struct InputError : std::invalid_argument {
  template <class... Part>
  explicit InputError(const Part&... part) : std::invalid_argument(message(part...)) {}
};

/// Returns work(); `where` is put before the message of an InputError.
template <class Work>
auto within(const std::string& where, const Work& work) {
  try {
    return work();
  } catch (const InputError& error) {
    throw InputError(where, error.what());
  }
}

/// Breakdown of the arithmetic (indefinite matrix, NaN).  Exit code 2.  Slow convergence is
/// not an error but a result, see contact::Report.
struct NumericalError : std::runtime_error {
  template <class... Part>
  explicit NumericalError(const Part&... part) : std::runtime_error(message(part...)) {}
};

}  // namespace epafi::bem
