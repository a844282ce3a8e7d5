# `cpack --config build/CPackConfig.cmake`: a Debian package with the program, the headers, the checkers of certificates, the
# man page and completions.
if(NOT PLUMBLINE_INSTALL)
  return()
endif()
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright COMPONENT program)
# The checkers of certificates, and what they check: they share nothing with the program but its package.
file(GLOB checkers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/proofs/*.py ${PROJECT_SOURCE_DIR}/proofs/*certificate-format.md)
install(FILES ${checkers} DESTINATION ${CMAKE_INSTALL_DATADIR}/plumbline/proofs COMPONENT program)
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "Plumbline")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# to draw figures; to share work among processes, to compile against the headers
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS gnuplot-nox)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "openmpi-bin, libeigen3-dev, libboost-dev, libgmp-dev, libmpfr-dev, libmpfi-dev")
include(CPack)
