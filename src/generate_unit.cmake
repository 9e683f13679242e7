# SPDX-License-Identifier: MIT
# What embed_files() and hash_files() have in common: a translation unit that a script (cmake -P) makes of files, again
# whenever one of them changes, appears or goes.

# generate_unit(variable SCRIPT s COMMENT c DIR folder NAMES f ... HEADER h NAMESPACE n FUNCTION f DEFINES D=v ...): in
# variable, the file that the script writes. NAMES are below DIR. The script gets DIR, the names in the lines of LIST,
# OUTPUT, HEADER, NAMESPACE, FUNCTION and DEFINES.
function(generate_unit variable)
  cmake_parse_arguments(ARG "" "SCRIPT;COMMENT;DIR;HEADER;NAMESPACE;FUNCTION" "NAMES;DEFINES" ${ARGN})
  set(dir ${PROJECT_SOURCE_DIR}/${ARG_DIR})
  list(TRANSFORM ARG_NAMES PREPEND ${dir}/ OUTPUT_VARIABLE files)
  list(TRANSFORM ARG_DEFINES PREPEND -D)
  set(output ${PROJECT_BINARY_DIR}/${ARG_FUNCTION}.cpp)
  # The list is a file, rewritten only when it differs: so the unit knows of a deleted file too.
  set(list ${PROJECT_BINARY_DIR}/${ARG_FUNCTION}.list)
  list(JOIN ARG_NAMES "\n" lines)
  file(GENERATE OUTPUT ${list} CONTENT "${lines}\n")
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DDIR=${dir} -DLIST=${list} -DOUTPUT=${output} -DHEADER=${ARG_HEADER}
            -DNAMESPACE=${ARG_NAMESPACE} -DFUNCTION=${ARG_FUNCTION} ${ARG_DEFINES} -P ${ARG_SCRIPT}
    DEPENDS ${files} ${list} ${ARG_SCRIPT}
    COMMENT "${ARG_COMMENT} ${ARG_DIR}"
    VERBATIM)
  set(${variable} ${output} PARENT_SCOPE)
endfunction()
