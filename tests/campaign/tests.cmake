# SPDX-License-Identifier: MIT
# A test for each kind of shape, so that they run beside each other.
foreach(name counts seams)
  add_executable(campaign_test_${name} campaign/test_${name}.cpp)
  target_link_libraries(campaign_test_${name} PRIVATE strahl_test_main strahl_selftest strahl_nearest)
  target_precompile_headers(campaign_test_${name} REUSE_FROM strahl_test_headers)
endforeach()
foreach(kind sphere plane box triangle parallelogram disk cylinder)
  add_test(NAME campaign_test_counts_${kind} COMMAND campaign_test_counts ${kind})
  set_tests_properties(campaign_test_counts_${kind} PROPERTIES LABELS device SKIP_RETURN_CODE 77 TIMEOUT 600)
endforeach()
add_test(NAME campaign_test_seams COMMAND campaign_test_seams)
set_tests_properties(campaign_test_seams PROPERTIES LABELS device SKIP_RETURN_CODE 77 TIMEOUT 600)
strahl_test(campaign/test_neighbours.cpp LABEL device LIBS strahl_selftest)
