# add_package(<name> SOURCES <file>... [USES <target>...] [HIDES <target>...])
#
# USES appears in the package's headers, HIDES only in its .cpp files: what is hidden
# stays out of every other package's compile time.
function(add_package name)
  cmake_parse_arguments(arg "" "" "SOURCES;USES;HIDES" ${ARGN})
  add_library(epafi_${name} ${arg_SOURCES})
  add_library(Epafi::${name} ALIAS epafi_${name})
  target_compile_features(epafi_${name} PUBLIC cxx_std_17)
  target_compile_options(epafi_${name} PRIVATE -Wall -Wextra -Wpedantic -Wshadow)
  target_include_directories(epafi_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/packages>)
  target_link_libraries(epafi_${name} PUBLIC ${arg_USES} PRIVATE ${arg_HIDES})
endfunction()

# add_unit_tests(<suite> SOURCES <file>... [USES <target>...] [LABEL <label>]):
# one executable, one ctest entry <label>.<suite>; the label defaults to "unit".
function(add_unit_tests suite)
  cmake_parse_arguments(arg "" "LABEL" "SOURCES;USES" ${ARGN})
  if(NOT arg_LABEL)
    set(arg_LABEL unit)
  endif()
  add_executable(${suite}_${arg_LABEL}_tests ${PROJECT_SOURCE_DIR}/test/TestMain.cpp ${arg_SOURCES})
  target_compile_options(${suite}_${arg_LABEL}_tests PRIVATE -Wall -Wextra -Wshadow)
  target_include_directories(${suite}_${arg_LABEL}_tests PRIVATE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/test)
  target_link_libraries(${suite}_${arg_LABEL}_tests PRIVATE ${arg_USES} trilinos::Teuchos)
  add_test(NAME ${arg_LABEL}.${suite} COMMAND ${suite}_${arg_LABEL}_tests)
  set_tests_properties(${arg_LABEL}.${suite} PROPERTIES LABELS ${arg_LABEL}
    ENVIRONMENT "${EPAFI_TEST_ENVIRONMENT}")
endfunction()
