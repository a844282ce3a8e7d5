# Builds and runs a project that uses the library. Run with cmake -DWAY=<way> -DSOURCE=<root of the project>
# -DBINARY=<its build tree> -DCOMPILER=<C++ compiler> -DGENERATOR=<CMake generator> -P build.cmake, where the way is
#   install     the whole project, installed into an empty folder: the program runs, the package is found
#   core-only   the library alone, configured where no other package can be found, then installed
#   port        by the port for vcpkg, whose commands port.cmake stands in for
#   subproject, fetch   by add_subdirectory, by FetchContent
set(place ${BINARY}/tests/consumer/${WAY})
set(prefix ${place}/prefix)
file(REMOVE_RECURSE ${place})
set(ENV{DESTDIR} "")

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
function(configure source build)
  run(${CMAKE_COMMAND} -S ${source} -B ${build} -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${COMPILER} ${ARGN})
endfunction()

# What the library alone must do without.
set(absent "")
foreach(package GiNaC fmt nlohmann_json tomlplusplus CLI11 OpenSSL MuJoCo doctest Python3 LAPACK)
  list(APPEND absent -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()

set(way package)
if(WAY STREQUAL install)
  run(${CMAKE_COMMAND} --install ${BINARY} --prefix ${prefix})
  run(${prefix}/bin/plumbline critical OUTPUT_QUIET)
  foreach(file share/man/man1/plumbline.1 share/bash-completion/completions/plumbline
               share/zsh/vendor-completions/_plumbline)
    if(NOT EXISTS ${prefix}/${file})
      message(FATAL_ERROR "found no ${file}, expected it installed")
    endif()
  endforeach()
elseif(WAY STREQUAL core-only)
  configure(${SOURCE} ${place}/library -DPLUMBLINE_CORE_ONLY=ON ${absent})
  run(${CMAKE_COMMAND} --install ${place}/library --prefix ${prefix})
elseif(WAY STREQUAL port)
  include(${CMAKE_CURRENT_LIST_DIR}/port.cmake)
else()
  set(way ${WAY})
endif()
configure(${SOURCE}/tests/consumer ${place}/build -DWAY=${way} -DPLUMBLINE=${SOURCE} -DCMAKE_PREFIX_PATH=${prefix}
          -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF ${absent})
run(${CMAKE_COMMAND} --build ${place}/build)
run(${place}/build/consumer)
