# SPDX-License-Identifier: MIT
# One program, a test for each kind of shape, so that they run beside each other.
add_executable(campaign_test_counts campaign/test_counts.cpp)
target_link_libraries(campaign_test_counts PRIVATE strahl_test_main strahl_selftest strahl_nearest)
target_precompile_headers(campaign_test_counts REUSE_FROM strahl_test_headers)
foreach(kind sphere plane box triangle parallelogram disk cylinder)
  add_test(NAME campaign_test_counts_${kind} COMMAND campaign_test_counts ${kind})
  set_tests_properties(campaign_test_counts_${kind} PROPERTIES LABELS device SKIP_RETURN_CODE 77 TIMEOUT 600)
endforeach()
