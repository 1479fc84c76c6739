# Can another application use what `cmake --install` leaves?
#
#   cmake -DBUILD=<build folder> -DSOURCES=<of the application> -DPROGRAM=<its name>
#         -DRANKS=1,2 -DMPIEXEC=<mpirun> -DWORK=<temporary folder> [-DOPTIONS=<for cmake>]
#         [-DCHECKER=<a Python program> -DEPAFI=<the program>] [-DPAGE=<page>.md]
#         [-DWITHOUT=<a package that it must not look for>]
#         -P CheckHowto.cmake
#
# Installs into a fresh folder, builds a copy of the application against it, runs it on each
# number of ranks; all must print the same numbers to 1e-9 of the column's scale, and the table
# of the page, if one is given, be what they print.
# Or leaves all that to the checker.
cmake_minimum_required(VERSION 3.20)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\nended with ${result}:\n${said}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix --component development)
file(COPY ${SOURCES}/ DESTINATION ${WORK}/sources)
run(${CMAKE_COMMAND} -S ${WORK}/sources -B ${WORK}/build -G Ninja ${OPTIONS}
  -DCMAKE_PREFIX_PATH=${WORK}/prefix)
run(${CMAKE_COMMAND} --build ${WORK}/build)
if(WITHOUT)
  file(STRINGS ${WORK}/build/CMakeCache.txt found REGEX "^${WITHOUT}_")
  if(found)
    message(FATAL_ERROR "${PROGRAM} looks for ${WITHOUT}: ${found}")
  endif()
endif()

if(CHECKER)
  run(/usr/bin/python3 ${CHECKER} ${WORK}/build/${PROGRAM} ${WORK}/sources ${WORK} ${EPAFI} ${MPIEXEC})
  return()
endif()

string(REPLACE "," ";" RANKS "${RANKS}")
foreach(ranks IN LISTS RANKS)
  execute_process(COMMAND timeout 60 ${MPIEXEC} -n ${ranks} ${WORK}/build/${PROGRAM}
    RESULT_VARIABLE result OUTPUT_FILE ${WORK}/${ranks}.txt ERROR_VARIABLE said)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${PROGRAM} on ${ranks} ranks ended with ${result}:\n${said}")
  endif()
  list(APPEND outputs ${WORK}/${ranks}.txt)
endforeach()

run(awk -f ${CMAKE_CURRENT_LIST_DIR}/CompareColumns.awk ${outputs})
if(PAGE)
  list(GET outputs 0 output)
  run(awk -f ${CMAKE_CURRENT_LIST_DIR}/ComparePage.awk ${PAGE} ${output})
endif()
