#pragma once

#include "bem/base/SchemaRow.hpp"

#include <vector>

namespace epafi::drivers {

/// The path that loads follow: it starts unloaded at t = 0 and is solved up to each of
/// `times`, in this order.  Without times there is no path, only one load at t = 1.
struct History {
  std::vector<double> times;
  /// Smallest step; 0: 1/64 of a step, with a tolerance 1/1024.
  double minimumStep = 0;
  double tolerance = 0;  ///< relative time error of friction's work; 0: steps as given

  /// Smallest number of steps up to each time with a tolerance; fewer could miss loads
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
/// \throws bem::InputError if Times do not increase from 0 on, if Steps are not one or as
///   many as Times, if Minimum Step is too long for a Tolerance, or if there are other keys and
///   no Times.
History parseHistory(const Teuchos::ParameterList& list);

}  // namespace epafi::drivers
