#include "bem/simd/InstructionSet.hpp"

#include <atomic>

namespace epafi::bem {

std::vector<InstructionSet> instructionSets() {
  std::vector<InstructionSet> sets = {InstructionSet::Baseline};
#ifdef EPAFI_X86
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
    sets.push_back(InstructionSet::Avx2);
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl")) {
      sets.push_back(InstructionSet::Avx512);
      // Zen 4: the reciprocal of a pack takes ten cycles of the divider, which runs
      // beside the multipliers, or nine of the multipliers
      if (__builtin_cpu_is("amdfam19h"))
        sets.push_back(InstructionSet::Avx512Dividing);
    }
  }
#endif
  return sets;
}

namespace {

std::atomic<InstructionSet>& used() {
  static std::atomic<InstructionSet> set = instructionSets().back();
  return set;
}

}  // namespace

InstructionSet usedInstructionSet() { return used().load(std::memory_order_relaxed); }

WithInstructionSet::WithInstructionSet(InstructionSet set)
    : before_(used().exchange(set)) {}

WithInstructionSet::~WithInstructionSet() { used() = before_; }

}  // namespace epafi::bem
