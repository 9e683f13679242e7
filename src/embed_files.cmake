# SPDX-License-Identifier: MIT
# Turns every file of a folder that matches into a raw string of one generated translation unit, again whenever one of
# them changes, appears or goes. The folder, the names below it and what the unit defines come from embed_files(); run
# by it as a script too (cmake -P).
if(CMAKE_SCRIPT_MODE_FILE)
  file(STRINGS ${LIST} names)
  # Only string(APPEND) touches the contents: list commands would eat semicolons and brackets.
  set(text "#include \"${HEADER}\"\n\nnamespace ${NAMESPACE} {\n\n")
  string(APPEND text "const std::vector<${TYPE}>& ${FUNCTION}() {\n  static const std::vector<${TYPE}> files = {\n")
  foreach(name IN LISTS names)
    file(READ "${DIR}/${name}" content)
    string(APPEND text "{\"${name}\", R\"embedded(${content})embedded\"},\n")
  endforeach()
  string(APPEND text "  };\n  return files;\n}\n\n}  // namespace ${NAMESPACE}\n")
  file(WRITE ${OUTPUT} "${text}")
  return()
endif()

set(EMBED_FILES_SCRIPT ${CMAKE_CURRENT_LIST_FILE})

# embed_files(variable DIR folder PATTERNS *.h ... HEADER h NAMESPACE n TYPE t FUNCTION f): in variable, the generated
# file, which defines const std::vector<n::t>& n::f(), {name, content} each, as h declares it.
function(embed_files variable)
  cmake_parse_arguments(ARG "" "DIR;HEADER;NAMESPACE;TYPE;FUNCTION" "PATTERNS" ${ARGN})
  set(dir ${PROJECT_SOURCE_DIR}/${ARG_DIR})
  list(TRANSFORM ARG_PATTERNS PREPEND ${dir}/)
  file(GLOB_RECURSE names RELATIVE ${dir} CONFIGURE_DEPENDS ${ARG_PATTERNS})
  list(TRANSFORM names PREPEND ${dir}/ OUTPUT_VARIABLE files)
  set(output ${PROJECT_BINARY_DIR}/${ARG_FUNCTION}.cpp)
  # The list is a file, rewritten only when it differs: so a deleted file leaves the binary too.
  set(list ${PROJECT_BINARY_DIR}/${ARG_FUNCTION}.list)
  list(JOIN names "\n" names)
  file(GENERATE OUTPUT ${list} CONTENT "${names}\n")
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DDIR=${dir} -DLIST=${list} -DOUTPUT=${output} -DHEADER=${ARG_HEADER}
            -DNAMESPACE=${ARG_NAMESPACE} -DTYPE=${ARG_TYPE} -DFUNCTION=${ARG_FUNCTION} -P ${EMBED_FILES_SCRIPT}
    DEPENDS ${files} ${list} ${EMBED_FILES_SCRIPT}
    COMMENT "Embedding ${ARG_DIR}"
    VERBATIM)
  set(${variable} ${output} PARENT_SCOPE)
endfunction()
