#pragma once

#include "bem/simd/InstructionSet.hpp"
#include "bem/simd/Pack.hpp"

namespace epafi::bem {

#ifdef EPAFI_X86
template <Division How, class Kernel>
__attribute__((target("avx512f,avx512dq,avx512vl,fma"))) void runAvx512(
    const Kernel& kernel) {
  kernel.template run<How>();
}

template <class Kernel>
__attribute__((target("avx2,fma"))) void runAvx2(const Kernel& kernel) {
  kernel.template run<Division::Fused>();
}
#endif

/// Calls kernel.run<Division>(), compiled for usedInstructionSet().
/// \pre run() and all functions that it calls are EPAFI_INLINE
template <class Kernel>
void dispatch(const Kernel& kernel) {
  switch (usedInstructionSet()) {
#ifdef EPAFI_X86
    case InstructionSet::Avx512Dividing:
      return runAvx512<Division::Exact>(kernel);
    case InstructionSet::Avx512:
      return runAvx512<Division::Fused>(kernel);
    case InstructionSet::Avx2:
      return runAvx2(kernel);
#endif
    default:
      return kernel.template run<Division::Exact>();
  }
}

}  // namespace epafi::bem
