# add_package(<name> SOURCES <file>... [USES <target>...] [HIDES <target>...])
#
# USES appears in the package's headers, HIDES only in its .cpp files: what is hidden
# stays out of every other package's compile time.  What stands below packages/ is installed.
function(add_package name)
  cmake_parse_arguments(arg "" "" "SOURCES;USES;HIDES" ${ARGN})
  add_library(epafi_${name} ${arg_SOURCES})
  add_library(Epafi::${name} ALIAS epafi_${name})
  target_compile_features(epafi_${name} PUBLIC cxx_std_17)
  target_compile_options(epafi_${name} PRIVATE -Wall -Wextra -Wpedantic -Wshadow)
  target_include_directories(epafi_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/packages>)
  target_link_libraries(epafi_${name} PUBLIC ${arg_USES} PRIVATE ${arg_HIDES})
  if(CMAKE_CURRENT_SOURCE_DIR MATCHES "^${PROJECT_SOURCE_DIR}/packages/")
    set_property(GLOBAL APPEND PROPERTY EPAFI_PACKAGES ${name})
  endif()
endfunction()

# add_unit_tests(<suite> SOURCES <file>... [USES <target>...] [LABEL <label>] [RANKS]):
# one executable, one ctest entry <label>.<suite>; the label defaults to "unit".
#
# With RANKS (test/Processes.hpp) the suite is also border.unit.<suite>.2 and .3: all ranks of
# mpirun together.
function(add_unit_tests suite)
  cmake_parse_arguments(arg "RANKS" "LABEL" "SOURCES;USES" ${ARGN})
  if(NOT arg_LABEL)
    set(arg_LABEL unit)
  endif()
  set(program ${suite}_${arg_LABEL}_tests)
  if(arg_RANKS)
    add_border_program(${suite}_ranks_tests
      SOURCES ${arg_SOURCES} ${PROJECT_SOURCE_DIR}/test/RankProcesses.cpp USES ${arg_USES})
    list(APPEND arg_SOURCES ${PROJECT_SOURCE_DIR}/test/SerialProcesses.cpp)
  endif()
  add_executable(${program} ${PROJECT_SOURCE_DIR}/test/TestMain.cpp ${arg_SOURCES})
  target_compile_options(${program} PRIVATE -Wall -Wextra -Wshadow)
  target_include_directories(${program} PRIVATE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/test)
  target_link_libraries(${program} PRIVATE ${arg_USES} trilinos::Teuchos)
  add_test(NAME ${arg_LABEL}.${suite} COMMAND ${program})
  set_tests_properties(${arg_LABEL}.${suite} PROPERTIES LABELS ${arg_LABEL}
    ENVIRONMENT "${EPAFI_TEST_ENVIRONMENT}")
  if(arg_RANKS)
    add_border_test(unit.${suite} RANKS 2 3 TIMEOUT 240 COMMAND $<TARGET_FILE:${suite}_ranks_tests>)
  endif()
endfunction()

# add_border_test(<name> RANKS <n>... COMMAND <command>...): border.<name>.<n>, the command
# under mpirun with n ranks each.  A test that hangs is a failure within the time allowed.
function(add_border_test name)
  cmake_parse_arguments(arg "" "TIMEOUT" "RANKS;COMMAND" ${ARGN})
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 60)
  endif()
  math(EXPR arg_TIMEOUT "${arg_TIMEOUT} * ${EPAFI_TEST_PATIENCE}")
  foreach(ranks IN LISTS arg_RANKS)
    add_test(NAME border.${name}.${ranks}
      COMMAND timeout ${arg_TIMEOUT} ${MPIEXEC_EXECUTABLE} ${MPIEXEC_NUMPROC_FLAG} ${ranks}
        ${arg_COMMAND})
    set_tests_properties(border.${name}.${ranks} PROPERTIES LABELS border PROCESSORS ${ranks}
      COST ${ranks}000 ENVIRONMENT "${EPAFI_RANKS_ENVIRONMENT}")
  endforeach()
endfunction()

# add_border_program(<name> SOURCES <file>... [USES <target>...]): unit tests that start MPI.
function(add_border_program name)
  cmake_parse_arguments(arg "" "" "SOURCES;USES" ${ARGN})
  add_executable(${name} ${PROJECT_SOURCE_DIR}/test/BorderMain.cpp ${arg_SOURCES})
  target_compile_options(${name} PRIVATE -Wall -Wextra -Wshadow)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/test)
  target_link_libraries(${name} PRIVATE ${arg_USES} Epafi::bem_tpetra trilinos::Teuchos)
endfunction()

# add_border_tests(<suite> SOURCES <file>... [USES <target>...]): a suite of unit tests that
# starts MPI, with 1, 2 and 3 ranks.
function(add_border_tests suite)
  add_border_program(${suite}_border_tests ${ARGN})
  add_border_test(${suite} RANKS 1 2 3 COMMAND $<TARGET_FILE:${suite}_border_tests>)
endfunction()
