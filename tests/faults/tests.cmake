# SPDX-License-Identifier: MIT
# Faults that are put into the built program (docs/reliability.md).
add_library(fail_write MODULE faults/fail_write.cpp)
target_link_libraries(fail_write PRIVATE ${CMAKE_DL_LIBS})
strahl_test(faults/test_write_faults.cpp LABEL device SOURCES cli/program.cpp TIMEOUT 300)
strahl_runs_program(faults_tests)
add_dependencies(faults_tests fail_write)
target_compile_definitions(faults_tests PRIVATE STRAHL_FAIL_WRITE="$<TARGET_FILE:fail_write>")
add_test(NAME faults_test_write_faults_all COMMAND faults_tests "-#" "[#test_write_faults]")
set_tests_properties(faults_test_write_faults_all PROPERTIES LABELS slow TIMEOUT 3600 ENVIRONMENT STRAHL_ALL_FAULTS=1)
