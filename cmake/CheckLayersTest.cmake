# Does the layers test fail when it should?  cmake -DWORK=<temporary folder> -P CheckLayersTest.cmake
#
# Each case is a tree with one file that has one include; the sound ones must pass, each bad
# one must fail with its own message.
cmake_minimum_required(VERSION 3.20)
set(check ${CMAKE_CURRENT_LIST_DIR}/CheckLayers.cmake)

# expect(<file> <include> <message>): an empty message means that the tree is sound.
function(expect file include message)
  file(REMOVE_RECURSE ${WORK})
  file(MAKE_DIRECTORY ${WORK}/packages/bem)
  file(WRITE ${WORK}/${file} "#pragma once\n#include ${include}\n")
  execute_process(COMMAND ${CMAKE_COMMAND} -DROOT=${WORK} -P ${check}
    RESULT_VARIABLE result ERROR_VARIABLE said)
  string(REGEX REPLACE "[ \n]+" " " said "${said}")
  if(message STREQUAL "" AND NOT result EQUAL 0)
    message(SEND_ERROR "${file} with ${include} should pass, but: ${said}")
  elseif(NOT message STREQUAL "" AND result EQUAL 0)
    message(SEND_ERROR "${file} with ${include} should fail, and passes")
  elseif(NOT message STREQUAL "" AND NOT said MATCHES "${message}")
    message(SEND_ERROR "${file} with ${include} should fail with '${message}', but: ${said}")
  endif()
endfunction()

expect(packages/bem/mesh/Mesh.hpp      "\"bem/base/Vec2.hpp\""           "")
expect(packages/bem/mesh/Mesh.hpp      "<vector>"                        "")
expect(packages/contact/law/Law.hpp    "\"bem/base/Vec2.hpp\""           "")
expect(drivers/scene/Scene.hpp         "\"adaptivity/refine/Refine.hpp\"" "")
expect(drivers/scene/Scene.hpp         "<muParser.h>"                    "")
expect(packages/contact/law/Law.cpp    "<Teuchos_ParameterList.hpp>"     "")
expect(packages/contact/nox/Newton.cpp "<NOX.H>"                         "")
expect(packages/bem/tpetra/Algebra.hpp "<Tpetra_Map.hpp>"                "")

expect(packages/bem/mesh/Mesh.hpp      "\"contact/law/Law.hpp\""         "later layer contact/")
expect(packages/bem/mesh/Mesh.cpp      "<contact/law/Law.hpp>"           "later layer contact/")
expect(packages/contact/law/Law.hpp    "\"adaptivity/mark/Mark.hpp\""    "later layer adaptivity/")
expect(packages/contact/nox/Newton.cpp "\"drivers/scene/Scene.hpp\""     "later layer drivers/")
expect(packages/adaptivity/mark/Mark.cpp "\"drivers/scene/Scene.hpp\""         "later layer drivers/")
expect(packages/bem/mesh/Mesh.hpp      "\"bem/moments/Tile.hpp\""         "later floor bem/moments/")
expect(packages/bem/tractions/Rows.hpp "\"bem/operators/Rows.hpp\""      "")
expect(packages/contact/solve/Step.cpp "\"contact/nox/NoxNewton.hpp\"" "later floor contact/nox/")
expect(packages/contact/nox/Newton.cpp "\"contact/newton/Newton.hpp\""    "")
expect(packages/adaptivity/singular/Points.cpp "\"adaptivity/mark/Mark.hpp\"" "later floor adaptivity/mark/")
expect(drivers/run/Levels.hpp          "\"drivers/output/HistoryTables.hpp\""  "later floor drivers/output/")
expect(drivers/scene/Scene.cpp         "<drivers/commands/Check.hpp>"    "later floor drivers/commands/")
expect(drivers/attic/Scene.cpp         "<vector>"                        "has no floor")
expect(packages/bem/mesh/Mesh.hpp      "\"../../contact/law/Law.hpp\""   "path from packages/ on")
foreach(header Tpetra_Map.hpp BelosSolverManager.hpp Thyra_VectorBase.hpp NOX.H LOCA.H
    Stratimikos_DefaultLinearSolverBuilder.hpp Kokkos_Core.hpp mpi.h hdf5.h muParser.h
    Teuchos_GlobalMPISession.hpp)
  expect(packages/bem/operators/Pair.cpp  "<${header}>"                   "which belongs into")
  expect(packages/contact/solve/Step.hpp "<${header}>"                   "which belongs into")
endforeach()
expect(packages/contact/law/Law.hpp    "<Teuchos_ParameterList.hpp>"     "forward declare Teuchos")
expect(packages/bem/base/Matrix.hpp    "<cblas.h>"                       "standard library only")

# A tree without packages is a wrong call, not a sound tree.
execute_process(COMMAND ${CMAKE_COMMAND} -DROOT=${WORK}/nowhere -P ${check}
  RESULT_VARIABLE result ERROR_QUIET)
if(result EQUAL 0)
  message(SEND_ERROR "a folder without packages should fail, and passes")
endif()
file(REMOVE_RECURSE ${WORK})
