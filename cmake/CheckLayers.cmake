# The architecture as a test:  cmake -DROOT=<source folder> -P CheckLayers.cmake
#
#   1. A layer includes only itself and the layers to its left, by full path; within a layer a
#      folder includes only itself, its floor, and the floors to its left.
#   2. Solver, MPI, HDF5 and muParser headers live at the border only.
#   3. Other headers of the packages take nothing but the standard library (their .cpp files
#      Boost, too); Teuchos is forward declared, but by bem/base/Acceptor.hpp, the base of what takes
#      its options from a list.
cmake_minimum_required(VERSION 3.20)
set(layers bem contact adaptivity drivers)
# Folders of one floor, divided by |, may include each other.  A layer without floors is free.
set(bem_floors base|simd algebra basis quadrature geometry mesh moments kernel space
  operators|tractions compressed fields tpetra)
set(contact_floors law conditions multiplier problem stabilization opposite body compressed system
  results equation path newton solve nox)
set(adaptivity_floors singular refine mark estimate)
set(drivers_floors triangulate process scene run output commands bench)
set(border "^(packages/bem/tpetra/|packages/contact/nox/|drivers/)")
set(foreign "Tpetra|Belos|Thyra|NOX|LOCA|Stratimikos|Kokkos|Xpetra|Epetra|Piro|Amesos|mpi\\.h|hdf5|H5|muParser|Teuchos_[A-Za-z]*(Mpi|MPI)")

if(NOT EXISTS ${ROOT}/packages/bem)
  message(FATAL_ERROR "no packages/bem in ROOT=${ROOT}")
endif()

# floor_of(<layer> <folder> <result>): which floor a folder is on, -1 if it has none
function(floor_of layer folder result)
  set(at 0)
  foreach(floor IN LISTS ${layer}_floors)
    if(folder MATCHES "^(${floor})$")
      set(${result} ${at} PARENT_SCOPE)
      return()
    endif()
    math(EXPR at "${at} + 1")
  endforeach()
  set(${result} -1 PARENT_SCOPE)
endfunction()

while(layers)
  list(POP_FRONT layers layer)
  list(JOIN layers "|" later)
  set(folder packages/${layer})
  if(layer STREQUAL "drivers")
    set(folder drivers)
  endif()

  file(GLOB_RECURSE files RELATIVE ${ROOT}
    ${ROOT}/${folder}/*.[chi]pp ${ROOT}/${folder}/*.h ${ROOT}/${folder}/*.in[cl])
  foreach(file IN LISTS files)
    set(floor -1)
    if(DEFINED ${layer}_floors AND file MATCHES "^${folder}/([^/]*)/")
      set(room ${CMAKE_MATCH_1})
      floor_of(${layer} ${room} floor)
      if(floor EQUAL -1)
        message(SEND_ERROR "${file}: the folder ${layer}/${room} has no floor in CheckLayers.cmake")
      endif()
    endif()
    file(STRINGS ${ROOT}/${file} includes REGEX "^[ \t]*#[ \t]*include")
    foreach(include IN LISTS includes)
      if(NOT include MATCHES "[<\"]([^>\"]*)[>\"]")
        continue()
      endif()
      set(header "${CMAKE_MATCH_1}")

      if(NOT floor EQUAL -1 AND header MATCHES "^${layer}/([^/]*)/")
        set(other ${CMAKE_MATCH_1})
        floor_of(${layer} ${other} above)
        if(above GREATER floor)
          message(SEND_ERROR "${file} includes ${header}, of the later floor ${layer}/${other}/")
        endif()
      endif()
      if(later AND header MATCHES "^(${later})/")
        message(SEND_ERROR "${file} includes ${header}, of the later layer ${CMAKE_MATCH_1}/")
      elseif(header MATCHES "(^|/)\\.\\.?/")
        message(SEND_ERROR "${file} includes ${header}: write the path from packages/ on")
      elseif(NOT file MATCHES "${border}")
        if(header MATCHES "^([^/]*/)*(${foreign})")
          message(SEND_ERROR "${file} includes ${header}, which belongs into bem/tpetra, contact/nox or drivers")
        elseif(NOT file MATCHES "\\.cpp$" AND include MATCHES "<")
          if(header MATCHES "^Teuchos" AND file MATCHES "bem/base/Acceptor\\.hpp$")
            continue()
          elseif(header MATCHES "^Teuchos")
            message(SEND_ERROR "${file} includes ${header}: forward declare Teuchos in a core header")
          elseif(header MATCHES "[./]" AND NOT header MATCHES "intrin\\.h$")
            message(SEND_ERROR "${file} includes ${header}: core headers use the standard library only")
          endif()
        endif()
      endif()
    endforeach()
  endforeach()
endwhile()
