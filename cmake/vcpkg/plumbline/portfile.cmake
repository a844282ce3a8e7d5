# The header-only library, from the checkout that this port stands in:
#
#   vcpkg install plumbline --overlay-ports=cmake/vcpkg
#
# vcpkg has no port of MPFI: it is the system's (Debian package libmpfi-dev).
cmake_path(SET SOURCE_PATH NORMALIZE "${CMAKE_CURRENT_LIST_DIR}/../../..")
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}" OPTIONS -DPLUMBLINE_CORE_ONLY=ON -DPLUMBLINE_INSTALL=ON)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/plumbline)
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug" "${CURRENT_PACKAGES_DIR}/lib")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
