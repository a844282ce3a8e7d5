# What every compiled target of the project shares and no user of the library gets: the standard, warnings, speed,
# precompiled headers. A target of ours is made as usual and links plumbline-flags privately.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
if(PROJECT_IS_TOP_LEVEL)
  set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
endif()

# A compiler cache, if there is one; it is told what it needs to cache uses of precompiled headers, and that one clone's
# files are another's. It looks at the time of included files: of one that is edited while it is compiled (in a unity build
# every file is included) it would keep the old object under the new text.
find_program(CCACHE ccache)
if(CCACHE AND PROJECT_IS_TOP_LEVEL AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
      CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}
      ${CCACHE})
endif()

if(PLUMBLINE_SANITIZE)
  add_compile_options(-fsanitize=${PLUMBLINE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  # What the sanitizers cannot see: an empty optional that is read, a place between a vector's size and its capacity.
  add_compile_definitions(_GLIBCXX_ASSERTIONS)
  # GCC 12 finds the standard library's own regular expressions uninitialized between its checks.
  add_compile_options("$<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>")
  add_link_options(-fsanitize=${PLUMBLINE_SANITIZE})
  set(sanitizer_environment "LSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/tests/leaks.supp:print_suppressions=0")
endif()

# Warnings are errors in our own code; the headers of other packages are not ours to judge.
add_library(plumbline-flags INTERFACE)
# Not among them are three that GCC 12 raises on insertions of a literal into a std::string.
target_compile_options(plumbline-flags INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror
  "$<$<CXX_COMPILER_ID:GNU>:-Wno-restrict;-Wno-stringop-overflow;-Wno-array-bounds>")
# Files compiled together fill more memory than GCC lets grow unasked: without this it collects garbage for a tenth of its time.
target_compile_options(plumbline-flags INTERFACE "$<$<CXX_COMPILER_ID:GNU>:SHELL:--param ggc-min-heapsize=1500000>")

# Options of the packages whose headers are precompiled: all who use them must see the same macros.
set(packages Eigen3::Eigen Boost::headers MPFI::MPFI fmt::fmt nlohmann_json::nlohmann_json CLI11::CLI11)
foreach(package ${packages})
  target_compile_definitions(plumbline-flags INTERFACE $<TARGET_PROPERTY:${package},INTERFACE_COMPILE_DEFINITIONS>)
  target_compile_options(plumbline-flags INTERFACE $<TARGET_PROPERTY:${package},INTERFACE_COMPILE_OPTIONS>)
endforeach()

# A way to compile: plumbline_way(<way> FLAGS <option> ... HEADERS <header> ...) makes the targets plumbline-<way>-flags
# and plumbline-<way>-headers, the headers of other packages parsed once. To load them costs a compiler about a fifth of
# parsing them, so that a way has those alone that most of its files include.
function(plumbline_way way)
  cmake_parse_arguments(PARSE_ARGV 1 way "" "" "FLAGS;HEADERS")
  add_library(plumbline-${way}-flags INTERFACE)
  target_link_libraries(plumbline-${way}-flags INTERFACE plumbline-flags)
  target_compile_options(plumbline-${way}-flags INTERFACE ${way_FLAGS})
  set(empty ${CMAKE_CURRENT_BINARY_DIR}/${way}-headers.cpp)
  file(CONFIGURE OUTPUT ${empty} CONTENT "")
  add_library(plumbline-${way}-headers OBJECT ${empty})
  target_link_libraries(plumbline-${way}-headers PRIVATE plumbline-${way}-flags ${packages})
  target_precompile_headers(plumbline-${way}-headers PRIVATE ${way_HEADERS})
endfunction()
# The first line of every target of ours: plumbline_own(<target> <way>).
function(plumbline_own target way)
  target_link_libraries(${target} PRIVATE plumbline-${way}-flags)
  target_precompile_headers(${target} REUSE_FROM plumbline-${way}-headers)
endfunction()

# Where nothing takes time, the compiler's time is worth more.
set(quick $<$<CONFIG:Release>:-O1>)
# What the extension module of Python links: code that runs wherever it is loaded, while calls within a file stay direct.
set(anywhere "")
if(PLUMBLINE_PYTHON)
  set(anywhere -fPIC -fno-semantic-interposition)
endif()
set(numbers <Eigen/Core> <Eigen/LU> <boost/multiprecision/gmp.hpp> <boost/multiprecision/mpfr.hpp>)
set(texts <fmt/format.h> <fmt/ranges.h> <nlohmann/json.hpp>)
plumbline_way(text FLAGS ${quick} ${anywhere} HEADERS ${texts})
plumbline_way(proof FLAGS ${anywhere} HEADERS ${numbers} <boost/multiprecision/mpfi.hpp> <fmt/format.h>)
plumbline_way(claim FLAGS ${quick} HEADERS ${numbers} <boost/multiprecision/mpfi.hpp> <fmt/format.h> <ginac/ginac.h>)
plumbline_way(fit FLAGS ${anywhere} HEADERS <Eigen/Dense> <fmt/format.h>)
plumbline_way(verb FLAGS ${quick} HEADERS ${texts} ${numbers} <CLI/CLI.hpp>)
