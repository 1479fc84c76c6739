#pragma once

#include "bem/simd/InstructionSet.hpp"
#include "bem/simd/Pack.hpp"

namespace epafi::bem {

template <Division How, class Kernel>
EPAFI_AVX512 void runAvx512(const Kernel& kernel) {
  kernel.template run<How>();
}

template <class Kernel>
EPAFI_AVX2 void runAvx2(const Kernel& kernel) {
  kernel.template run<Division::Fused>();
}

/// Calls kernel.run<Division>(), compiled for an instruction set that the processor has.
/// \pre run() and all functions that it calls are EPAFI_INLINE
template <class Kernel>
void dispatch(InstructionSet set, const Kernel& kernel) {
  switch (set) {
    case InstructionSet::Avx512Dividing:
      return runAvx512<Division::Exact>(kernel);
    case InstructionSet::Avx512:
      return runAvx512<Division::Fused>(kernel);
    case InstructionSet::Avx2:
      return runAvx2(kernel);
    case InstructionSet::Baseline:
      return kernel.template run<Division::Exact>();
  }
}

}  // namespace epafi::bem
