#pragma once

#include "bem/operators/Assembly.hpp"
#include "reference/QuadOperators.hpp"

namespace epafi::reference {

/// The largest error of an entry, relative to the norms of the element pair blocks that
/// make it up.
struct OperatorErrors {
  double singleLayer = 0;
  double doubleLayer = 0;
  double hypersingular = 0;
};

OperatorErrors operatorErrors(const bem::Operators& operators,
                              const QuadOperators& exact);

}  // namespace epafi::reference
