# SPDX-License-Identifier: MIT
# The built program, run as a user runs it. unit: no OpenCL device is needed.
function(strahl_cli_tests label)
  foreach(test ${ARGN})
    strahl_test(cli/test_${test}.cpp LABEL ${label} SOURCES cli/program.cpp LIBS nlohmann_json::nlohmann_json)
    add_dependencies(cli_test_${test} strahl-bin)
    target_compile_definitions(cli_test_${test} PRIVATE STRAHL_PROGRAM="$<TARGET_FILE:strahl-bin>")
  endforeach()
endfunction()
strahl_cli_tests(unit usage output_checks compare devices explain rays_file stats_json)
strahl_cli_tests(device render interrupt stats intersect)
