#pragma once

#include "bem/base/Family.hpp"
#include "bem/base/Keys.hpp"
#include "bem/compressed/CompressedOperators.hpp"
#include "bem/operators/SteklovPoincare.hpp"
#include "bem/tpetra/BelosOptions.hpp"

#include <memory>
#include <string>

namespace epafi::drivers {

class Ranks;

/// How linear systems are solved.
struct LinearOptions {
  std::string method = "Automatic";  ///< a name of linearMethods()
  bem::BelosOptions belos;
  bem::Compression compression;

  void keys(bem::Keys& keys);
};

/// A way to solve with the boundary operators.
struct LinearMethod {
  /// What it asks for: dense matrices, compressed operators, or whichever costs less.
  enum class Operators { Dense, Compressed, Cheaper };

  const char* name = nullptr;
  const char* meaning = nullptr;
  /// Null: by Cholesky's factors.
  std::unique_ptr<const bem::SingleLayerSolver> (*solver)(
      const Ranks& ranks, const LinearOptions& options) = nullptr;
  Operators operators = Operators::Dense;
};

/// All of them; a program may add others before it reads its first scene.
bem::Family<LinearMethod>& linearMethods();

}  // namespace epafi::drivers
