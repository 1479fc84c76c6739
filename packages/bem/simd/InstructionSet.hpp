#pragma once

#include <vector>

// Elsewhere kernels are compiled for the baseline alone.
#if defined(__x86_64__) || defined(__i386__)
#define EPAFI_X86
#endif

namespace epafi::bem {

/// Instruction sets for which kernels are compiled; each includes the previous ones.
/// Results differ by rounding.
enum class InstructionSet {
  Baseline,
  Avx2,
  Avx512,
  Avx512Dividing  ///< Avx512 with Division::Exact: the divider runs beside the multipliers
};

/// Instruction sets of this processor, in the order of the enumeration.
std::vector<InstructionSet> instructionSets();

/// The one that kernels run with: the last of instructionSets(), unless a test has chosen another.
InstructionSet usedInstructionSet();

/// For tests: kernels of the whole process run with one of instructionSets() while it lives.
class WithInstructionSet {
 public:
  explicit WithInstructionSet(InstructionSet set);
  ~WithInstructionSet();
  WithInstructionSet(const WithInstructionSet&) = delete;
  WithInstructionSet& operator=(const WithInstructionSet&) = delete;

 private:
  InstructionSet before_;
};

}  // namespace epafi::bem
