# EPAFI_TEST_ENVIRONMENT: for the property ENVIRONMENT of every test.
execute_process(COMMAND bash ${CMAKE_CURRENT_LIST_DIR}/environment.sh
  OUTPUT_VARIABLE EPAFI_TEST_ENVIRONMENT OUTPUT_STRIP_TRAILING_WHITESPACE
  COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE "\n" ";" EPAFI_TEST_ENVIRONMENT "${EPAFI_TEST_ENVIRONMENT}")
# Tests run side by side: each keeps to one thread of BLAS.
list(APPEND EPAFI_TEST_ENVIRONMENT OPENBLAS_NUM_THREADS=1
  LSAN_OPTIONS=suppressions=${CMAKE_CURRENT_LIST_DIR}/lsan.supp:print_suppressions=0
  UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1)

# How much longer than usual a test may take.
set(EPAFI_TEST_PATIENCE 1)
if(CMAKE_BUILD_TYPE STREQUAL Asan)
  set(EPAFI_TEST_PATIENCE 10)
endif()
list(APPEND EPAFI_TEST_ENVIRONMENT EPAFI_TEST_PATIENCE=${EPAFI_TEST_PATIENCE})

# EPAFI_RANKS_ENVIRONMENT: likewise where a test runs on several ranks.  Leaks are told apart from
# those of Open MPI by whole stacks, which the fast unwinder cuts short at its libraries; without
# it programs take four times as long.
set(EPAFI_RANKS_ENVIRONMENT ${EPAFI_TEST_ENVIRONMENT} OMP_NUM_THREADS=1
  ASAN_OPTIONS=fast_unwind_on_malloc=0)
