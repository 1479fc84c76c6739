#pragma once

#include "bem/base/SchemaRow.hpp"

namespace epafi::bem {

/// Options of BelosSolver.
struct BelosOptions {
  double tolerance = 1e-13;      ///< residual relative to the right-hand side, > 0
  int maximumIterations = 1000;  ///< > 0
  int blockSize = 64;            ///< right-hand sides solved together, > 0
};

/// Schema of the options; and options from a list completed by it.
SchemaRows belosRows();
BelosOptions parseBelos(const Teuchos::ParameterList& list);

}  // namespace epafi::bem
