# Everything Epafi takes from Debian 12, each as one target.
#
# Trilinos 13.2 exports plain library targets without include folders, so a wrapper per package
# carries the include folder (SYSTEM: its headers are not free of warnings).
find_package(OpenMP REQUIRED COMPONENTS CXX)
find_package(LAPACK REQUIRED)
find_package(muparser REQUIRED CONFIG)
find_package(yaml-cpp REQUIRED CONFIG)
set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE)
find_package(CGAL 5.5 REQUIRED CONFIG)  # drivers/triangulate alone
find_package(CLI11 REQUIRED CONFIG)
find_package(Boost 1.74 REQUIRED)
find_package(MPI REQUIRED COMPONENTS C CXX)
set(HDF5_PREFER_PARALLEL ON)
find_package(HDF5 REQUIRED COMPONENTS C)
if(NOT HDF5_IS_PARALLEL)
  message(FATAL_ERROR "HDF5 with MPI is needed: libhdf5-openmpi-dev; found ${HDF5_C_LIBRARIES}")
endif()
find_package(Trilinos 13.2 REQUIRED CONFIG
  COMPONENTS Teuchos Kokkos Tpetra Belos Thyra ThyraTpetraAdapters Stratimikos NOX)

# add_trilinos(<name> <library>...): the target trilinos::<name>.  Debian puts trilinos_ before the
# libraries' own names.
function(add_trilinos name)
  if(NOT TARGET trilinos_teuchoscore)
    list(TRANSFORM ARGN REPLACE "^trilinos_" "")
  endif()
  add_library(trilinos_wrapper_${name} INTERFACE)
  add_library(trilinos::${name} ALIAS trilinos_wrapper_${name})
  target_include_directories(trilinos_wrapper_${name} SYSTEM INTERFACE ${Trilinos_INCLUDE_DIRS})
  target_link_libraries(trilinos_wrapper_${name} INTERFACE ${ARGN})
  set_property(GLOBAL APPEND PROPERTY EPAFI_WRAPPERS trilinos_wrapper_${name})
endfunction()

add_trilinos(Teuchos trilinos_teuchosparameterlist trilinos_teuchosparser
  trilinos_teuchoscore trilinos_teuchosnumerics trilinos_teuchoscomm MPI::MPI_CXX)
add_trilinos(Tpetra trilinos_tpetra trilinos_belostpetra trilinos_teuchosparameterlist MPI::MPI_CXX)
add_trilinos(NOX trilinos_locathyra trilinos_loca trilinos_nox trilinos_stratimikosbelos
  trilinos_thyratpetra trilinos_tpetra trilinos_teuchosparameterlist MPI::MPI_CXX)

# Where Debian's Python looks for packages that do not come from Debian, seen from the prefix.
execute_process(COMMAND /usr/bin/python3 -c "import sys; print('%d.%d' % sys.version_info[:2])"
  OUTPUT_VARIABLE epafi_python_version OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
set(EPAFI_PYTHON lib/python${epafi_python_version}/dist-packages CACHE STRING
  "Where the Python front goes, below the prefix")
