# cmake -DSOURCE=… -DHEADER=… -P WriteCommit.cmake: a header with the commit that is built; empty where the sources are no
# checkout of their own. Written anew only when the commit is another.
execute_process(COMMAND git -C ${SOURCE} rev-parse --show-toplevel OUTPUT_VARIABLE root OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
set(commit "")
if(root STREQUAL SOURCE)
  execute_process(COMMAND git -C ${SOURCE} describe --always --dirty --exclude * --abbrev=12
                  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
file(CONFIGURE OUTPUT ${HEADER} CONTENT "#pragma once\n\nnamespace plumbline::app {\n\ninline constexpr const char* commit = \"${commit}\";\n\n}  // namespace plumbline::app\n")
