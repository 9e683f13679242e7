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

include(${CMAKE_CURRENT_LIST_DIR}/generate_unit.cmake)
set(EMBED_FILES_SCRIPT ${CMAKE_CURRENT_LIST_FILE})

# embed_files(variable DIR folder PATTERNS *.h ... HEADER h NAMESPACE n TYPE t FUNCTION f): in variable, the generated
# file, which defines const std::vector<n::t>& n::f(), {name, content} each, as h declares it.
function(embed_files variable)
  cmake_parse_arguments(ARG "" "DIR;HEADER;NAMESPACE;TYPE;FUNCTION" "PATTERNS" ${ARGN})
  set(dir ${PROJECT_SOURCE_DIR}/${ARG_DIR})
  list(TRANSFORM ARG_PATTERNS PREPEND ${dir}/)
  file(GLOB_RECURSE names RELATIVE ${dir} CONFIGURE_DEPENDS ${ARG_PATTERNS})
  generate_unit(output SCRIPT ${EMBED_FILES_SCRIPT} COMMENT Embedding DIR ${ARG_DIR} NAMES ${names} HEADER ${ARG_HEADER}
                NAMESPACE ${ARG_NAMESPACE} FUNCTION ${ARG_FUNCTION} DEFINES TYPE=${ARG_TYPE})
  set(${variable} ${output} PARENT_SCOPE)
endfunction()
