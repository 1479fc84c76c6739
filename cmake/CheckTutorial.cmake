# Is the tutorial's scene a scene?  The pieces of XML on the page, one after the other, must pass
# `epafi check`, and their first level must solve.
#
#   cmake -DTUTORIAL=tutorial.md -DEPAFI=<program> -DWORK=<temporary folder> -P CheckTutorial.cmake
cmake_minimum_required(VERSION 3.20)
file(READ ${TUTORIAL} rest)
set(scene "")
while(TRUE)
  string(FIND "${rest}" "```xml\n" begin)
  if(begin EQUAL -1)
    break()
  endif()
  math(EXPR begin "${begin} + 7")
  string(SUBSTRING "${rest}" ${begin} -1 rest)
  string(FIND "${rest}" "```" end)
  string(SUBSTRING "${rest}" 0 ${end} piece)
  string(SUBSTRING "${rest}" ${end} -1 rest)
  string(APPEND scene "${piece}")
endwhile()
file(REMOVE_RECURSE ${WORK})
file(WRITE ${WORK}/block.xml "${scene}")
execute_process(COMMAND ${EPAFI} check block.xml WORKING_DIRECTORY ${WORK}
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${EPAFI} run block.xml --set "Adaptivity->Maximum Levels=1"
  WORKING_DIRECTORY ${WORK} COMMAND_ERROR_IS_FATAL ANY)
