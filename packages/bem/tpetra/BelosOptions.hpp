#pragma once

#include "bem/base/SchemaRow.hpp"

namespace epafi::bem {

/// When BelosSolver is content.
struct BelosOptions {
  double tolerance = 1e-13;      ///< residual relative to the right hand side, > 0
  int maximumIterations = 1000;  ///< > 0
  int blockSize = 64;            ///< right hand sides at once, > 0
};

/// The keys of a list of these, and what a list that they have completed says.
SchemaRows belosRows();
BelosOptions parseBelos(const Teuchos::ParameterList& list);

}  // namespace epafi::bem
