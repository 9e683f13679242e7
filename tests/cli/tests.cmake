# SPDX-License-Identifier: MIT
# The built program, run as a user runs it. unit: no OpenCL device is needed.
foreach(test usage option_values distinct_files unreadable_inputs output_checks compare devices explain load_progress rays_file stats_json)
  strahl_test(cli/test_${test}.cpp LABEL unit SOURCES cli/program.cpp LIBS nlohmann_json::nlohmann_json)
endforeach()
foreach(test driver_environment render goals interrupt stats intersect canary stress tradeoff bench explain_cost)
  strahl_test(cli/test_${test}.cpp LABEL device SOURCES cli/program.cpp LIBS nlohmann_json::nlohmann_json)
endforeach()
strahl_runs_program(cli_tests)
