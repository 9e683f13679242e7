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

set(HASH_FILES_SCRIPT ${CMAKE_CURRENT_LIST_FILE})

# hash_files(variable DIR folder FILES f ... HEADER h NAMESPACE n FUNCTION f): in variable, the generated file, which
# defines const char* n::f(), 16 hexadecimal digits, as h declares it. FILES are names below DIR, wherever that is.
function(hash_files variable)
  cmake_parse_arguments(ARG "" "DIR;HEADER;NAMESPACE;FUNCTION" "FILES" ${ARGN})
  set(dir ${PROJECT_SOURCE_DIR}/${ARG_DIR})
  set(names ${ARG_FILES})
  list(SORT names)
  list(TRANSFORM names PREPEND ${dir}/ OUTPUT_VARIABLE files)
  set(output ${PROJECT_BINARY_DIR}/${ARG_FUNCTION}.cpp)
  # The list is a file, rewritten only when it differs: so a deleted file changes the hash too.
  set(list ${PROJECT_BINARY_DIR}/${ARG_FUNCTION}.list)
  list(JOIN names "\n" lines)
  file(GENERATE OUTPUT ${list} CONTENT "${lines}\n")
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DDIR=${dir} -DLIST=${list} -DOUTPUT=${output} -DHEADER=${ARG_HEADER}
            -DNAMESPACE=${ARG_NAMESPACE} -DFUNCTION=${ARG_FUNCTION} -P ${HASH_FILES_SCRIPT}
    DEPENDS ${files} ${list} ${HASH_FILES_SCRIPT}
    COMMENT "Hashing ${ARG_DIR}"
    VERBATIM)
  # By itself, so that a change of any file compiles nothing else.
  set_source_files_properties(${output} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  set(${variable} ${output} PARENT_SCOPE)
endfunction()
