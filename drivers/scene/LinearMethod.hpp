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

/// Options for solving linear systems.
struct LinearOptions {
  std::string method = "Automatic";  ///< a name in linearMethods()
  bem::BelosOptions belos;
  bem::Compression compression;

  void keys(bem::Keys& keys);
};

/// A method that solves systems with the boundary operators.
struct LinearMethod {
  /// Form of the operators: dense matrices, compressed operators, or the cheaper of both.
  enum class Operators { Dense, Compressed, Cheaper };

  const char* name = nullptr;
  const char* meaning = nullptr;
  /// A null pointer means Cholesky factorization.
  std::unique_ptr<const bem::SingleLayerSolver> (*solver)(
      const Ranks& ranks, const LinearOptions& options) = nullptr;
  Operators operators = Operators::Dense;
};

/// All methods; a program may add others before it reads its first scene.
bem::Family<LinearMethod>& linearMethods();

}  // namespace epafi::drivers
