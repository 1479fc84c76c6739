#pragma once

#include "bem/base/SchemaRow.hpp"
#include "bem/base/Vec2.hpp"

#include <vector>

namespace Teuchos {
class ParameterList;
}

namespace epafi::drivers {

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
