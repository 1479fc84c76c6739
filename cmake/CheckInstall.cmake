# Does `cmake --install` leave all that a user looks for, and does the installed program solve
# and draw without the tree it came from?
#
#   cmake -DBUILD=<build folder> -DWORK=<temporary folder> -P CheckInstall.cmake
cmake_minimum_required(VERSION 3.20)

file(REMOVE_RECURSE ${WORK})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
foreach(file bin/epafi libexec/epafi/triangulate share/man/man1/epafi.1
    share/bash-completion/completions/epafi share/epafi/schema/epafi.rng
    share/epafi/schema/scene.json share/epafi/schema/study.json share/epafi/parameters share/epafi/scenes/tresca.xml
    share/epafi/studies/work-precision.xml share/doc/epafi/README.md share/doc/epafi/LICENSE share/doc/epafi/doc/theory
    share/doc/epafi/doc/howto/embed/main.cpp share/doc/epafi/doc/images
    include/epafi/contact/system/ContactSystem.hpp)
  if(NOT EXISTS ${WORK}/prefix/${file})
    message(SEND_ERROR "${file} is not installed")
  endif()
endforeach()
set(scenes ${WORK}/prefix/share/epafi/scenes)
foreach(arguments "run;${scenes}/patch.xml" "plot;patch.out;--field;syy"
    "study;${scenes}/../studies/paper/figure4.xml;--no-plot" "schema" "help;--format;man")
  execute_process(COMMAND ${WORK}/prefix/bin/epafi ${arguments} WORKING_DIRECTORY ${WORK}
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endforeach()
file(GLOB python ${WORK}/prefix/lib/python3.*/dist-packages)
execute_process(COMMAND ${CMAKE_COMMAND} -E env PYTHONPATH=${python} PYTHONDONTWRITEBYTECODE=1
  /usr/bin/python3 -c "import epafi, sys; sys.exit(not epafi.run('${scenes}/patch.xml').converged)"
  WORKING_DIRECTORY ${WORK} COMMAND_ERROR_IS_FATAL ANY)
if(NOT EXISTS ${WORK}/patch.out/syy.png)
  message(FATAL_ERROR "the installed program does not draw")
endif()
