#pragma once

#include "bem/base/SchemaRow.hpp"
#include "bem/base/Vec2.hpp"

#include <optional>
#include <vector>

namespace epafi::drivers {

/// Limits of a run.
struct RunLimits {
  int levels = 6;                ///< the first included
  long degreesOfFreedom = 4000;  ///< of a level, displacement and multiplier
  double estimate = 0;           ///< the run ends at a smaller estimate
  /// ... and if Level::relativeEstimate is at most this.
  std::optional<double> tolerance{};
  std::optional<double> memory;  ///< of a level, all processes [MiB]; empty: free memory
};

/// Schema rows of RunLimits; limits of a validated list.
bem::SchemaRows limitRows();
RunLimits parseLimits(const Teuchos::ParameterList& list);

/// Output of a level besides the tables.
struct OutputOptions {
  int contactSamples = 8;  ///< per element
  std::vector<bem::Vec2> interiorPoints;
  bool fields = true;  ///< write boundary.csv, solution.hdf, data of pictures
};

/// Schema rows of OutputOptions; options of a validated list.
bem::SchemaRows outputRows();
OutputOptions parseOutput(const Teuchos::ParameterList& list);

}  // namespace epafi::drivers
