#pragma once

#include "bem/base/Family.hpp"
#include "bem/base/SchemaRow.hpp"
#include "bem/operators/SteklovPoincare.hpp"
#include "bem/tpetra/BelosOptions.hpp"

#include <memory>
#include <string>

namespace epafi::drivers {

class Ranks;

/// How linear systems are solved.
struct LinearOptions {
  std::string method = "Dense";  ///< a name of linearMethods()
  bem::BelosOptions belos;
};

/// The keys of a list of these, and what a list that they have completed says.
bem::SchemaRows linearRows();
LinearOptions parseLinear(const Teuchos::ParameterList& list);

/// A way to invert the single layer potential.
struct LinearMethod {
  const char* name;
  const char* meaning;
  /// Null: by Cholesky's factors.
  std::unique_ptr<const bem::SingleLayerSolver> (*solver)(const Ranks& ranks,
                                                          const LinearOptions& options);
};

/// All of them; a program may add others before it reads its first scene.
bem::Family<LinearMethod>& linearMethods();

}  // namespace epafi::drivers
