# Runs the port with stand-ins for the commands of vcpkg, as its documentation has them, where there is no vcpkg and no network.
set(CURRENT_PACKAGES_DIR ${prefix})

function(vcpkg_cmake_configure)
  cmake_parse_arguments(PARSE_ARGV 0 port "" SOURCE_PATH OPTIONS)
  configure(${port_SOURCE_PATH} ${place}/library -DCMAKE_INSTALL_LIBDIR=lib ${port_OPTIONS} ${absent})
endfunction()

function(vcpkg_cmake_install)
  run(${CMAKE_COMMAND} --install ${place}/library --prefix ${prefix})
endfunction()

# To where vcpkg looks, a folder nearer to the prefix.
function(vcpkg_cmake_config_fixup)
  cmake_parse_arguments(PARSE_ARGV 0 port "" CONFIG_PATH "")
  file(MAKE_DIRECTORY ${prefix}/share)
  file(RENAME ${prefix}/${port_CONFIG_PATH} ${prefix}/share/plumbline)
  file(READ ${prefix}/share/plumbline/plumblineTargets.cmake targets)
  string(REGEX REPLACE "(get_filename_component\\(_IMPORT_PREFIX [^\n]*\n)+"
                       "get_filename_component(_IMPORT_PREFIX \"\${CMAKE_CURRENT_LIST_DIR}/../../\" ABSOLUTE)\n" targets "${targets}")
  file(WRITE ${prefix}/share/plumbline/plumblineTargets.cmake "${targets}")
endfunction()

function(vcpkg_install_copyright)
  cmake_parse_arguments(PARSE_ARGV 0 port "" "" FILE_LIST)
  file(INSTALL ${port_FILE_LIST} DESTINATION ${prefix}/share/plumbline RENAME copyright)
endfunction()

include(${SOURCE}/cmake/vcpkg/plumbline/portfile.cmake)
file(READ ${SOURCE}/cmake/vcpkg/plumbline/vcpkg.json port)
string(JSON version GET "${port}" version-semver)
file(STRINGS ${SOURCE}/CMakeLists.txt project REGEX "^project\\(plumbline VERSION ${version} ")
if(NOT project)
  message(FATAL_ERROR "vcpkg.json: found version ${version}, expected that of CMakeLists.txt")
endif()
foreach(left lib debug)
  if(EXISTS ${prefix}/${left})
    message(FATAL_ERROR "found ${left}/ in the port's package, expected headers and share/ alone")
  endif()
endforeach()
