# Installs the project into an empty folder and builds and runs a project that finds it there. Run with
# cmake -DBINARY=<build tree> -DSOURCE=<this folder> -DCOMPILER=<C++ compiler> -P build.cmake
set(prefix ${BINARY}/tests/consumer/prefix)
set(build ${BINARY}/tests/consumer/build)
file(REMOVE_RECURSE ${prefix} ${build})
set(ENV{DESTDIR} "")
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BINARY} --prefix ${prefix} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE} -B ${build} -DCMAKE_PREFIX_PATH=${prefix}
                        -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${build} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${build}/consumer COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${prefix}/bin/plumbline critical OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
