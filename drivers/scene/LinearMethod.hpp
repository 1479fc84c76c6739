#pragma once

#include "bem/base/Family.hpp"
#include "bem/base/SchemaRow.hpp"
#include "bem/compressed/CompressedOperators.hpp"
#include "bem/operators/SteklovPoincare.hpp"
#include "bem/tpetra/BelosOptions.hpp"

#include <memory>
#include <string>

namespace epafi::drivers {

class Ranks;
struct Scene;

/// How linear systems are solved.
struct LinearOptions {
  std::string method = "Automatic";  ///< a name of linearMethods()
  bem::BelosOptions belos;
  bem::Compression compression;
};

/// Schema rows of LinearOptions; options of a validated list.
bem::SchemaRows linearRows();
LinearOptions parseLinear(const Teuchos::ParameterList& list);

/// A way to solve with the boundary operators.
struct LinearMethod {
  /// Dense matrices, compressed operators, or whichever costs less.
  enum class Operators { Dense, Compressed, Cheaper };

  const char* name = nullptr;
  const char* meaning = nullptr;
  /// Null: Cholesky factorisation.
  std::unique_ptr<const bem::SingleLayerSolver> (*solver)(
      const Ranks& ranks, const LinearOptions& options) = nullptr;
  Operators operators = Operators::Dense;
};

/// \throws bem::InputError if the method cannot solve the scene
void checkLinear(const Scene& scene);

/// All methods; a program may add others before it reads its first scene.
bem::Family<LinearMethod>& linearMethods();

}  // namespace epafi::drivers
