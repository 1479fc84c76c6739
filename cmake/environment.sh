#!/bin/bash
# The environment in which Epafi's programs and tests run, one NAME=VALUE a line.
#
#   export $(cmake/environment.sh)        for a shell; CMake reads it into EPAFI_TEST_ENVIRONMENT

# Open MPI as root, with more ranks than cores, in containers that forbid one process to read
# another one's memory.
echo OMPI_ALLOW_RUN_AS_ROOT=1
echo OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
echo OMPI_MCA_rmaps_base_oversubscribe=1
echo OMPI_MCA_mpi_yield_when_idle=1
echo OMPI_MCA_btl_vader_single_copy_mechanism=none

# Debian's OpenBLAS does not recognise newer processors and falls back to SSE kernels, five
# times slower.  A core type that the processor lacks would be an illegal instruction.
flags=" $(grep -m1 '^flags' /proc/cpuinfo 2>/dev/null | cut -d: -f2) "
# AMD's family 25 has AVX-512 in halves, see drivers/process/Threads.cpp
grep -q '^vendor_id.*AuthenticAMD' /proc/cpuinfo 2>/dev/null &&
  grep -q '^cpu family[^0-9]*25$' /proc/cpuinfo && flags=${flags//avx512f/}
if [[ -n ${OPENBLAS_CORETYPE:-} ]]; then
  echo "OPENBLAS_CORETYPE=$OPENBLAS_CORETYPE"
elif [[ $flags == *" avx512f "* && $flags == *" avx512dq "* && $flags == *" avx512bw "* &&
        $flags == *" avx512vl "* && $flags == *" avx512cd "* ]]; then
  echo OPENBLAS_CORETYPE=SkylakeX
elif [[ $flags == *" avx2 "* && $flags == *" fma "* ]]; then
  echo OPENBLAS_CORETYPE=Haswell
fi
