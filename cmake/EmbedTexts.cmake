# Writes a header that holds text files as string constants: plumbline_embed_texts(target header NAME file NAME file ...).
# The program then finds them wherever it is installed.
function(plumbline_embed_texts target header)
  set(constants "")
  set(pairs ${ARGN})
  while(pairs)
    list(POP_FRONT pairs name file)
    file(READ ${file} text)
    string(APPEND constants "inline constexpr const char* ${name} = R\"text(${text})text\";\n")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  endwhile()
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/generated/${header}
       CONTENT "#pragma once\n\nnamespace plumbline {\n${constants}}  // namespace plumbline\n" @ONLY)
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/generated)
endfunction()
