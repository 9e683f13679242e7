# SPDX-License-Identifier: MIT
# Turns every file below cl/ into a raw string of one generated translation unit, again whenever one of them changes,
# appears or goes. Included by the top CMakeLists (sets STRAHL_EMBEDDED_KERNELS) and run by it as a script (cmake -P).
if(CMAKE_SCRIPT_MODE_FILE)
  file(STRINGS ${LIST} kernels)
  # Only string(APPEND) touches the contents: list commands would eat semicolons and brackets.
  set(text "#include \"device/embedded_kernels.h\"\n\nnamespace strahl {\n\n")
  string(APPEND text "const std::vector<EmbeddedKernel>& embedded_kernels() {\n"
         "  static const std::vector<EmbeddedKernel> kernels = {\n")
  foreach(kernel IN LISTS kernels)
    file(READ "${CL_DIR}/${kernel}" content)
    string(APPEND text "{\"${kernel}\", R\"kernel(${content})kernel\"},\n")
  endforeach()
  string(APPEND text "  };\n  return kernels;\n}\n\n}  // namespace strahl\n")
  file(WRITE ${OUTPUT} "${text}")
  return()
endif()

set(CL_DIR ${PROJECT_SOURCE_DIR}/cl)
file(GLOB_RECURSE kernels RELATIVE ${CL_DIR} CONFIGURE_DEPENDS cl/*.h cl/*.cl cl/*.def)
list(TRANSFORM kernels PREPEND ${CL_DIR}/ OUTPUT_VARIABLE STRAHL_KERNEL_FILES)
set(STRAHL_EMBEDDED_KERNELS ${PROJECT_BINARY_DIR}/embedded_kernels.cpp)
# The list is a file, rewritten only when it differs: so a deleted kernel leaves the binary too.
set(STRAHL_KERNEL_LIST ${PROJECT_BINARY_DIR}/kernels.list)
list(JOIN kernels "\n" kernels)
file(GENERATE OUTPUT ${STRAHL_KERNEL_LIST} CONTENT "${kernels}\n")
add_custom_command(
  OUTPUT ${STRAHL_EMBEDDED_KERNELS}
  COMMAND ${CMAKE_COMMAND} -DCL_DIR=${CL_DIR} -DLIST=${STRAHL_KERNEL_LIST}
          -DOUTPUT=${STRAHL_EMBEDDED_KERNELS} -P ${CMAKE_CURRENT_LIST_FILE}
  DEPENDS ${STRAHL_KERNEL_FILES} ${STRAHL_KERNEL_LIST} ${CMAKE_CURRENT_LIST_FILE}
  COMMENT "Embedding kernels"
  VERBATIM)
