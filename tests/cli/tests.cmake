# SPDX-License-Identifier: MIT
# The built program, run as a user runs it. unit: no OpenCL device is needed.
foreach(test usage option_values distinct_files unreadable_inputs output_checks compare devices explain load_progress rays_file stats_json hostile_scenes)
  strahl_test(cli/test_${test}.cpp LABEL unit SOURCES cli/program.cpp LIBS nlohmann_json::nlohmann_json)
endforeach()
strahl_test(cli/test_progress.cpp LABEL unit SOURCES ${PROJECT_SOURCE_DIR}/src/cli/progress_text.cpp
            ${PROJECT_SOURCE_DIR}/src/cli/progress_bar.cpp ${PROJECT_SOURCE_DIR}/src/cli/console.cpp ${PROJECT_SOURCE_DIR}/src/cli/printable.cpp LIBS fmt::fmt)
strahl_test(cli/test_summary.cpp LABEL unit SOURCES ${PROJECT_SOURCE_DIR}/src/cli/summary.cpp
            ${PROJECT_SOURCE_DIR}/src/cli/clipping.cpp LIBS fmt::fmt)
strahl_test(cli/test_picture_files.cpp LABEL unit SOURCES ${PROJECT_SOURCE_DIR}/src/cli/picture_files.cpp
            ${PROJECT_SOURCE_DIR}/src/cli/display.cpp ${PROJECT_SOURCE_DIR}/src/cli/output_file.cpp
            ${PROJECT_SOURCE_DIR}/src/cli/clipping.cpp ${PROJECT_SOURCE_DIR}/src/cli/console.cpp
            ${PROJECT_SOURCE_DIR}/src/cli/printable.cpp LIBS fmt::fmt)
strahl_test(cli/test_render_goal.cpp LABEL unit SOURCES ${PROJECT_SOURCE_DIR}/src/cli/render_goal.cpp
            ${PROJECT_SOURCE_DIR}/src/cli/goal_options.cpp ${PROJECT_SOURCE_DIR}/src/cli/keep_options.cpp
            ${PROJECT_SOURCE_DIR}/src/cli/number_options.cpp LIBS fmt::fmt)
foreach(test driver_environment render scene_aovs goals interrupt signals checkpoint memory_limit stats intersect canary stress tradeoff bench explain_cost explain_integrators several_devices)
  strahl_test(cli/test_${test}.cpp LABEL device SOURCES cli/program.cpp LIBS nlohmann_json::nlohmann_json fmt::fmt)
endforeach()
strahl_runs_program(cli_tests)
# The headers that most of them include take longer than they do.
set_target_properties(cli_tests PROPERTIES UNITY_BUILD_BATCH_SIZE 0)
add_test(NAME cli_test_checkpoint_kills COMMAND cli_tests "killed at any moment*")
set_tests_properties(cli_test_checkpoint_kills PROPERTIES LABELS slow TIMEOUT 3600 ENVIRONMENT STRAHL_KILLS=50)
add_test(NAME cli_test_parallel_recipe COMMAND ${CMAKE_CURRENT_LIST_DIR}/test_parallel_recipe $<TARGET_FILE:strahl-bin>
                                               ${PROJECT_SOURCE_DIR}/scenes/cornell/cornell-box.xml)
add_test(NAME cli_test_slurm_recipe COMMAND ${CMAKE_CURRENT_LIST_DIR}/test_slurm_recipe $<TARGET_FILE:strahl-bin>
                                            ${PROJECT_SOURCE_DIR}/scenes/cornell/cornell-box.xml)
set_tests_properties(cli_test_slurm_recipe PROPERTIES LABELS slow SKIP_RETURN_CODE 77 TIMEOUT 600)
set_tests_properties(cli_test_parallel_recipe PROPERTIES LABELS device SKIP_RETURN_CODE 77 TIMEOUT 120)
