# Is every source file formatted?  cmake -DROOT=<source folder> -P CheckFormat.cmake
#
# To format them:  clang-format-14 -i <file>...
cmake_minimum_required(VERSION 3.20)
find_program(clang_format NAMES clang-format-14 REQUIRED)
file(GLOB_RECURSE files
  ${ROOT}/packages/*.[ch]pp ${ROOT}/drivers/*.[ch]pp ${ROOT}/test/*.[ch]pp
  ${ROOT}/doc/howto/*.[ch]pp)
if(NOT files)
  message(FATAL_ERROR "no sources in ROOT=${ROOT}")
endif()
execute_process(COMMAND ${clang_format} --style=file --dry-run --Werror ${files}
  RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "some files are not formatted: clang-format-14 -i <file>")
endif()
