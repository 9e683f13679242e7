# SPDX-License-Identifier: MIT
# Faults that are put into the built program (docs/reliability.md).
foreach(shim fail_write fail_opencl fail_memory jump_clock count_memory)
  add_library(${shim} MODULE faults/${shim}.cpp)
  target_link_libraries(${shim} PRIVATE ${CMAKE_DL_LIBS})
  set_target_properties(${shim} PROPERTIES UNITY_BUILD OFF)
endforeach()
strahl_test(faults/test_write_faults.cpp LABEL device SOURCES cli/program.cpp TIMEOUT 300)
strahl_test(faults/test_opencl_faults.cpp LABEL device TIMEOUT 300)
strahl_test(faults/test_dropped_devices.cpp LABEL device TIMEOUT 300)
strahl_test(faults/test_after_the_picture.cpp LABEL device TIMEOUT 300)
strahl_test(faults/test_device_questions.cpp LABEL device TIMEOUT 300)
strahl_test(faults/test_clock_jumps.cpp LABEL device TIMEOUT 300 LIBS nlohmann_json::nlohmann_json)
strahl_test(faults/test_memory.cpp LABEL device TIMEOUT 300)
strahl_test(faults/test_film_copies.cpp LABEL device TIMEOUT 300)
strahl_runs_program(faults_tests)
add_dependencies(faults_tests fail_write fail_opencl fail_memory jump_clock count_memory)
target_compile_definitions(faults_tests PRIVATE STRAHL_FAIL_WRITE="$<TARGET_FILE:fail_write>"
                                                STRAHL_FAIL_OPENCL="$<TARGET_FILE:fail_opencl>"
                                                STRAHL_FAIL_MEMORY="$<TARGET_FILE:fail_memory>"
                                                STRAHL_JUMP_CLOCK="$<TARGET_FILE:jump_clock>"
                                                STRAHL_COUNT_MEMORY="$<TARGET_FILE:count_memory>")
add_test(NAME faults_test_write_faults_all COMMAND faults_tests "-#" "[#test_write_faults]")
set_tests_properties(faults_test_write_faults_all PROPERTIES LABELS slow TIMEOUT 3600 ENVIRONMENT STRAHL_ALL_FAULTS=1)
add_test(NAME faults_test_opencl_faults_all COMMAND faults_tests "-#" "[#test_opencl_faults]")
set_tests_properties(faults_test_opencl_faults_all PROPERTIES LABELS slow TIMEOUT 14400 ENVIRONMENT STRAHL_ALL_FAULTS=1)
add_test(NAME faults_test_memory_of_2000 COMMAND faults_tests "-#" "[#test_memory]")
set_tests_properties(faults_test_memory_of_2000 PROPERTIES LABELS slow TIMEOUT 600 ENVIRONMENT STRAHL_ALL_FAULTS=1)
