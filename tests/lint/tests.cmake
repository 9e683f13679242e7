# SPDX-License-Identifier: MIT
# What no compiler checks; docs: CONTRIBUTING.md. Not strahl_test: these are scripts.
function(strahl_lint name label timeout)
  add_test(NAME lint_${name} COMMAND ${ARGN})
  set_tests_properties(lint_${name} PROPERTIES LABELS ${label} TIMEOUT ${timeout})
endfunction()

set(lint ${CMAKE_CURRENT_LIST_DIR})
strahl_lint(format lint 120 ${lint}/format)
strahl_lint(house lint 120 ${lint}/house)
strahl_lint(lane_table lint 30 python3 -B ${lint}/lane_table --check)
strahl_lint(parameters lint 30 python3 -B ${lint}/parameters)
strahl_lint(changed_structs lint 30 python3 -B ${lint}/changed_structs)
strahl_lint(tour lint 30 python3 -B ${lint}/tour)
strahl_lint(rules_turn_red lint 120 python3 -B ${lint}/test_house.py)
strahl_lint(accuracy_page lint 30 python3 -B ${PROJECT_SOURCE_DIR}/docs/accuracy/measure --check all)
# The whole of src/ takes clang-tidy minutes on two cores; a few light sources are looked at every time.
strahl_lint(tidy_core lint 120 ${lint}/tidy ${PROJECT_BINARY_DIR} "^src/(errors|scene/validate|image/metrics).*cpp$")
strahl_lint(tidy slow 3600 ${lint}/tidy ${PROJECT_BINARY_DIR})

# The program that writes the kernel texts needs the list of them, which src/program owns.
if(EXISTS ${lint}/kernel_texts.cpp)
  add_executable(kernel_texts ${lint}/kernel_texts.cpp)
  target_link_libraries(kernel_texts PRIVATE strahl)
  strahl_lint(kernels lint 300 ${lint}/kernels $<TARGET_FILE:kernel_texts> --few)
  strahl_lint(kernels_all slow 900 ${lint}/kernels $<TARGET_FILE:kernel_texts>)
  strahl_lint(entry_parts lint 300 ${lint}/entry_parts $<TARGET_FILE:kernel_texts> ${PROJECT_SOURCE_DIR}/cl)
endif()
