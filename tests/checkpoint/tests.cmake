# SPDX-License-Identifier: MIT
strahl_test(checkpoint/test_checkpoint_file.cpp LABEL unit)
add_test(NAME checkpoint_test_hash_files
         COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/checkpoint/test_hash_files ${PROJECT_BINARY_DIR})
set_tests_properties(checkpoint_test_hash_files PROPERTIES LABELS unit TIMEOUT 60)
