# cpack --config build/CPackConfig.cmake: a package for Debian of all that is installed.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The Epafi authors")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/cmake/packaging/prerm)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)  # wants the packages dpkg-dev and file
set(CPACK_DEBIAN_PACKAGE_DEPENDS "openmpi-bin, python3-h5py, python3-matplotlib")
include(CPack)
