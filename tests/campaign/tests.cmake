# SPDX-License-Identifier: MIT
strahl_test(campaign/test_seams.cpp LABEL device LIBS strahl_selftest strahl_nearest TIMEOUT 600)
strahl_test(campaign/test_neighbours.cpp LABEL device LIBS strahl_selftest)
# A test for each kind of shape, so that they run beside each other.
target_sources(campaign_tests PRIVATE campaign/test_counts.cpp)
foreach(kind sphere plane box triangle parallelogram disk cylinder)
  add_test(NAME campaign_test_counts_${kind} COMMAND campaign_tests ${kind})
  set_tests_properties(campaign_test_counts_${kind} PROPERTIES LABELS device SKIP_RETURN_CODE 77 TIMEOUT 600)
endforeach()
