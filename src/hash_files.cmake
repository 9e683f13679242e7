# SPDX-License-Identifier: MIT
# A hash of files, as a function of one generated translation unit, made again whenever one of them changes, appears or
# goes. Nothing but that unit depends on it. The folder, the names below it and what the unit defines come from
# hash_files(); run by it as a script too (cmake -P).
if(CMAKE_SCRIPT_MODE_FILE)
  file(STRINGS ${LIST} names)
  set(hashes "")
  foreach(name IN LISTS names)
    file(SHA256 "${DIR}/${name}" hash)
    string(APPEND hashes "${hash} ${name}\n")
  endforeach()
  string(SHA256 hash "${hashes}")
  string(SUBSTRING ${hash} 0 16 hash)
  file(WRITE ${OUTPUT} "#include \"${HEADER}\"\n\nnamespace ${NAMESPACE} {\n\n"
                       "const char* ${FUNCTION}() { return \"${hash}\"; }\n\n}  // namespace ${NAMESPACE}\n")
  return()
endif()

include(${CMAKE_CURRENT_LIST_DIR}/generate_unit.cmake)
set(HASH_FILES_SCRIPT ${CMAKE_CURRENT_LIST_FILE})

# hash_files(variable DIR folder FILES f ... HEADER h NAMESPACE n FUNCTION f): in variable, the generated file, which
# defines const char* n::f(), 16 hexadecimal digits, as h declares it. FILES are names below DIR, wherever that is.
function(hash_files variable)
  cmake_parse_arguments(ARG "" "DIR;HEADER;NAMESPACE;FUNCTION" "FILES" ${ARGN})
  list(SORT ARG_FILES)
  generate_unit(output SCRIPT ${HASH_FILES_SCRIPT} COMMENT Hashing DIR ${ARG_DIR} NAMES ${ARG_FILES} HEADER ${ARG_HEADER}
                NAMESPACE ${ARG_NAMESPACE} FUNCTION ${ARG_FUNCTION})
  # By itself, so that a change of any file compiles nothing else.
  set_source_files_properties(${output} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  set(${variable} ${output} PARENT_SCOPE)
endfunction()
