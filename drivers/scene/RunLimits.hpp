#pragma once

#include "bem/base/SchemaRow.hpp"

#include <optional>

namespace Teuchos {
class ParameterList;
}

namespace epafi::drivers {

/// When a run ends that could go on.
struct RunLimits {
  int levels = 6;                ///< the first included
  long degreesOfFreedom = 4000;  ///< of a level, displacement and multiplier
  double estimate = 0;           ///< a smaller one ends the run
  std::optional<double> memory;  ///< of a level, all processes [MiB]; else what is free
};

/// The keys of a list of these, and what a list that they have completed says.
bem::SchemaRows limitRows();
RunLimits parseLimits(const Teuchos::ParameterList& list);

}  // namespace epafi::drivers
