# SPDX-License-Identifier: MIT
# Turns every file below cl/ into a raw string in one generated translation unit, again whenever one of them changes.
# Included by the top CMakeLists (sets STRAHL_EMBEDDED_KERNELS) and run by it as a script (cmake -P).
if(CMAKE_SCRIPT_MODE_FILE)
  file(GLOB_RECURSE kernels RELATIVE ${CL_DIR} ${CL_DIR}/*.h ${CL_DIR}/*.cl ${CL_DIR}/*.def)
  list(SORT kernels)
  set(text "#include \"device/embedded_kernels.h\"\n\nnamespace strahl {\n\n"
           "const std::vector<EmbeddedKernel>& embedded_kernels() {\n  static const std::vector<EmbeddedKernel> kernels = {\n")
  foreach(kernel ${kernels})
    file(READ ${CL_DIR}/${kernel} content HEX)
    # Through hex, because a CMake list would eat semicolons and brackets.
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "\\\\x\\1" content "${content}")
    string(REGEX REPLACE "((\\\\x[0-9a-f][0-9a-f])(\\\\x[0-9a-f][0-9a-f])?(\\\\x[0-9a-f][0-9a-f])?(\\\\x[0-9a-f][0-9a-f])?(\\\\x[0-9a-f][0-9a-f])?(\\\\x[0-9a-f][0-9a-f])?(\\\\x[0-9a-f][0-9a-f])?(\\\\x[0-9a-f][0-9a-f])?)" "\"\\1\"\n" content "${content}")
    list(APPEND text "{\"${kernel}\",\n${content}\"\"},\n")
  endforeach()
  list(APPEND text "  }\;\n  return kernels\;\n}\n\n}  // namespace strahl\n")
  string(JOIN "" text ${text})
  file(WRITE ${OUTPUT} "${text}")
  return()
endif()

file(GLOB_RECURSE STRAHL_KERNEL_FILES CONFIGURE_DEPENDS cl/*.h cl/*.cl cl/*.def)
set(STRAHL_EMBEDDED_KERNELS ${CMAKE_CURRENT_BINARY_DIR}/embedded_kernels.cpp)
add_custom_command(
  OUTPUT ${STRAHL_EMBEDDED_KERNELS}
  COMMAND ${CMAKE_COMMAND} -DCL_DIR=${CMAKE_CURRENT_SOURCE_DIR}/cl -DOUTPUT=${STRAHL_EMBEDDED_KERNELS}
          -P ${CMAKE_CURRENT_SOURCE_DIR}/src/device/embed_kernels.cmake
  DEPENDS ${STRAHL_KERNEL_FILES} ${CMAKE_CURRENT_SOURCE_DIR}/src/device/embed_kernels.cmake
  COMMENT "Embedding kernels"
  VERBATIM)
