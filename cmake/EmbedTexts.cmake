# Writes a header that holds text files as string constants; the program then finds them wherever it is installed.
#
#   plumbline_embed_texts(<target> <header> NAMESPACE <namespace>
#                         [TEXTS <constant> <file> ...]        one `const char*` a file
#                         [FOLDER <constant> <file> ...])      an array of pairs (name of the file, its text)
#
# Files are named from the root of the project.
function(plumbline_embed_texts target header)
  cmake_parse_arguments(PARSE_ARGV 2 embed "" "NAMESPACE" "TEXTS;FOLDER")
  set(constants "")
  while(embed_TEXTS)
    list(POP_FRONT embed_TEXTS name file)
    plumbline_text_literal(${file} literal)
    string(APPEND constants "inline constexpr const char* ${name} = ${literal};\n")
  endwhile()
  if(embed_FOLDER)
    list(POP_FRONT embed_FOLDER name)
    string(APPEND constants "inline constexpr std::pair<const char*, const char*> ${name}[] = {\n")
    foreach(file ${embed_FOLDER})
      plumbline_text_literal(${file} literal)
      cmake_path(GET file FILENAME file_name)
      string(APPEND constants "    {\"${file_name}\", ${literal}},\n")
    endforeach()
    string(APPEND constants "};\n")
  endif()
  string(CONCAT text "#pragma once\n\n#include <utility>\n\nnamespace ${embed_NAMESPACE} {\n\n" "${constants}"
                     "\n}  // namespace ${embed_NAMESPACE}\n")
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/generated/${header} CONTENT "@text@" @ONLY)
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/generated)
endfunction()

# The text of a file as a C++ literal.
function(plumbline_text_literal file literal)
  cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
  file(READ ${file} text)
  set(${literal} "R\"embedded(${text})embedded\"" PARENT_SCOPE)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
endfunction()
