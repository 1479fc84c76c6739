#pragma once

#include "bem/base/SchemaRow.hpp"

#include <vector>

namespace epafi::drivers {

/// The path that loads follow: it starts unloaded at t = 0 and is solved up to each of
/// `times`, in this order.  Without times there is no path, only one load at t = 1.
struct History {
  std::vector<double> times;
  /// What a step is halved down to; 0: 1/64 of that step, with a tolerance 1/1024.
  double minimumStep = 0;
  double tolerance = 0;  ///< of friction's work in time, relative; 0: steps as given

  /// Up to each time under a tolerance: fewer see little of what goes and comes back.
  static constexpr int fewestSteps = 8;

  explicit operator bool() const { return !times.empty(); }
  /// One of a scene without a path.
  int steps() const { return times.empty() ? 1 : static_cast<int>(times.size()); }
  double shortest(double step) const {
    return minimumStep > 0 ? minimumStep : step / (tolerance > 0 ? 1024 : 64);
  }
};

/// The keys of the list History, and what a list that they have completed says.
bem::SchemaRows historyRows();
/// \throws bem::InputError if Times do not increase from 0 on, if Steps are not one or as
///   many as Times, if Minimum Step is too long for a Tolerance, or if there are other keys and
///   no Times.
History parseHistory(const Teuchos::ParameterList& list);

}  // namespace epafi::drivers
