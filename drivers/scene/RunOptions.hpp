#pragma once

#include "bem/base/SchemaRow.hpp"
#include "bem/base/Vec2.hpp"

#include <optional>
#include <vector>

namespace epafi::drivers {

/// When a run ends that could go on.
struct RunLimits {
  int levels = 6;                ///< the first included
  long degreesOfFreedom = 4000;  ///< of a level, displacement and multiplier
  double estimate = 0;           ///< a smaller one ends the run
  /// So does a Level::relativeEstimate of at most this.
  std::optional<double> tolerance{};
  std::optional<double> memory;  ///< of a level, all processes [MiB]; else what is free
};

/// The keys of a list of these, and what a list that they have completed says.
bem::SchemaRows limitRows();
RunLimits parseLimits(const Teuchos::ParameterList& list);

/// What is written of a level beside tables.
struct OutputOptions {
  int contactSamples = 8;  ///< per element
  std::vector<bem::Vec2> interiorPoints;
  bool fields = true;  ///< write boundary.csv and what shows fields
};

/// The keys of a list of these, and what a list that they have completed says.
bem::SchemaRows outputRows();
OutputOptions parseOutput(const Teuchos::ParameterList& list);

}  // namespace epafi::drivers
