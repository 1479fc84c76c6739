#pragma once

#include <vector>

namespace epafi::bem {

/// What kernels are compiled for, beside the compiler's baseline; later ones include the
/// earlier.  Results differ by rounding.
enum class InstructionSet {
  Baseline,
  Avx2,
  Avx512,
  Avx512Dividing  ///< in halves, where dividing leaves the multipliers free
};

/// Those that this processor has.
std::vector<InstructionSet> instructionSets();

/// The last of them.
InstructionSet largestInstructionSet();

}  // namespace epafi::bem
