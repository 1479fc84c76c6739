# Is a generated file what the program says now?
#
#   cmake -DFILE=<file> -DEPAFI=<program> -DARGUMENTS=<of epafi> -P CheckGenerated.cmake
cmake_minimum_required(VERSION 3.20)
execute_process(COMMAND ${EPAFI} ${ARGUMENTS} OUTPUT_VARIABLE now COMMAND_ERROR_IS_FATAL ANY)
file(READ ${FILE} there)
string(LENGTH "${now}" length)
if(NOT there STREQUAL now OR length LESS 100)
  message(FATAL_ERROR "${FILE} is stale: build the target `generated`")
endif()
