# SPDX-License-Identifier: MIT
add_executable(mutants_ask mutants/ask.cpp)
target_link_libraries(mutants_ask PRIVATE strahl_selftest fmt::fmt)

add_test(NAME mutants_runner COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/test_mutants.py)
set_tests_properties(mutants_runner PROPERTIES LABELS unit TIMEOUT 60)

# Mutants against the killer that each names first: two cores, some 60 s, since each compiles its own kernels.
set(mutants ${CMAKE_CURRENT_LIST_DIR}/mutants.py)
add_test(NAME mutants COMMAND python3 -B ${mutants} ${PROJECT_BINARY_DIR})
set_tests_properties(mutants PROPERTIES LABELS device TIMEOUT 600 PROCESSORS 2)
add_test(NAME mutants_all COMMAND python3 -B ${mutants} ${PROJECT_BINARY_DIR} --all)
set_tests_properties(mutants_all PROPERTIES LABELS slow TIMEOUT 7200 PROCESSORS 2)
# Every mutant against every killer; goes on where it was stopped.
add_test(NAME mutants_matrix COMMAND python3 -B ${mutants} ${PROJECT_BINARY_DIR} --matrix)
set_tests_properties(mutants_matrix PROPERTIES LABELS slow TIMEOUT 14400 PROCESSORS 2)
