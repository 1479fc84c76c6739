# cmake --install <build> --prefix <folder>: the program, the libraries libepafi_<package>, the
# headers below include/epafi, and what find_package(Epafi COMPONENTS ...) needs.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(epafi_config ${CMAKE_INSTALL_LIBDIR}/cmake/Epafi)
get_property(epafi_packages GLOBAL PROPERTY EPAFI_PACKAGES)
list(APPEND epafi_packages scene run program)
get_property(epafi_wrappers GLOBAL PROPERTY EPAFI_WRAPPERS)

foreach(package IN LISTS epafi_packages)
  set_target_properties(epafi_${package} PROPERTIES EXPORT_NAME ${package})
  target_include_directories(epafi_${package}
    INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/epafi>)
  install(TARGETS epafi_${package} EXPORT EpafiTargets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
endforeach()
# epafi as a library, for programs that solve scenes or add to it.
foreach(headers . process scene run)
  file(GLOB epafi_headers ${PROJECT_SOURCE_DIR}/drivers/${headers}/*.hpp)
  install(FILES ${epafi_headers} COMPONENT development
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/epafi/drivers/${headers})
endforeach()
# The wrappers are no imported targets, so they can be exported along.
install(TARGETS ${epafi_wrappers} EXPORT EpafiTargets)
install(EXPORT EpafiTargets NAMESPACE Epafi:: DESTINATION ${epafi_config}
  COMPONENT development)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/packages/
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/epafi COMPONENT development
  FILES_MATCHING PATTERN "*.hpp")
# Side by side as in the tree, so that links among them lead somewhere.
foreach(file CHANGELOG.md CITATION.cff CONTRIBUTING.md LICENSE README.md SECURITY.md doc)
  if(IS_DIRECTORY ${PROJECT_SOURCE_DIR}/${file})
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/${file}
      DESTINATION share/doc/epafi COMPONENT documentation)
  else()
    install(FILES ${PROJECT_SOURCE_DIR}/${file}
      DESTINATION share/doc/epafi COMPONENT documentation)
  endif()
endforeach()

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/EpafiConfig.cmake.in
  ${PROJECT_BINARY_DIR}/EpafiConfig.cmake
  INSTALL_DESTINATION ${epafi_config} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/EpafiConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/EpafiConfig.cmake
  ${PROJECT_BINARY_DIR}/EpafiConfigVersion.cmake
  DESTINATION ${epafi_config} COMPONENT development)

install(TARGETS epafi RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
