#pragma once

#include "bem/base/SchemaRow.hpp"

#include <vector>

namespace epafi::drivers {

/// The path of the loads: it starts unloaded at t = 0 and is solved up to each of `times`
/// in this order.  Without times there is no path, only one load at t = 1.
struct History {
  std::vector<double> times;
  /// Shortest step; 0: 1/64 of a step, with a tolerance 1/1024.
  double minimumStep = 0;
  double tolerance = 0;  ///< relative time error of friction's work; 0: steps as given

  /// With a tolerance: smallest number of steps up to each time; fewer could miss loads
  /// that rise and fall in between.
  static constexpr int fewestSteps = 8;

  explicit operator bool() const { return !times.empty(); }
  /// Number of steps; 1 without a path.
  int steps() const { return times.empty() ? 1 : static_cast<int>(times.size()); }
  double shortest(double step) const {
    return minimumStep > 0 ? minimumStep : step / (tolerance > 0 ? 1024 : 64);
  }
};

/// Schema rows of the list History.
bem::SchemaRows historyRows();
/// \throws bem::InputError if Times do not increase from 0, if the number of Steps is
///   neither 1 nor that of Times, if Minimum Step is too long for the Tolerance, or if
///   there are other keys without Times.
History parseHistory(const Teuchos::ParameterList& list);

}  // namespace epafi::drivers
