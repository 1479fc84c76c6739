# EPAFI_TEST_ENVIRONMENT: for the property ENVIRONMENT of every test.
execute_process(COMMAND bash ${CMAKE_CURRENT_LIST_DIR}/environment.sh
  OUTPUT_VARIABLE EPAFI_TEST_ENVIRONMENT OUTPUT_STRIP_TRAILING_WHITESPACE
  COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE "\n" ";" EPAFI_TEST_ENVIRONMENT "${EPAFI_TEST_ENVIRONMENT}")
# Tests run side by side: each keeps to one thread of BLAS.  Open MPI never frees all it
# allocates, so the leak checker of sanitizer builds would report nothing else.
list(APPEND EPAFI_TEST_ENVIRONMENT OPENBLAS_NUM_THREADS=1 ASAN_OPTIONS=detect_leaks=0
  UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1)
