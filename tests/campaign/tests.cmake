# SPDX-License-Identifier: MIT
strahl_test(campaign/test_seams.cpp LABEL device LIBS strahl_selftest strahl_nearest TIMEOUT 600)
strahl_test(campaign/test_neighbours.cpp LABEL device LIBS strahl_selftest)
# A test for each kind of shape, so that they run beside each other.
target_sources(campaign_tests PRIVATE campaign/test_counts.cpp)
file(STRINGS ${PROJECT_SOURCE_DIR}/cl/shapes/shapes.def shape_kinds REGEX "^SHAPE\\(")
list(TRANSFORM shape_kinds REPLACE "^SHAPE\\(([a-z_]+),.*" "\\1")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/cl/shapes/shapes.def)
foreach(kind ${shape_kinds})
  add_test(NAME campaign_test_counts_${kind} COMMAND campaign_tests ${kind})
  set_tests_properties(campaign_test_counts_${kind} PROPERTIES LABELS device SKIP_RETURN_CODE 77 TIMEOUT 600)
endforeach()
# A million, and more of the kinds whose t is exact by the longest ways.
foreach(kind ${shape_kinds})
  set(cases 125000)
  if(kind STREQUAL sphere)
    set(cases 1000000)
  elseif(kind STREQUAL box)
    set(cases 1250000)
  endif()
  add_test(NAME campaign_test_counts_${kind}_all COMMAND campaign_tests ${kind})
  set_tests_properties(campaign_test_counts_${kind}_all PROPERTIES LABELS slow SKIP_RETURN_CODE 77 TIMEOUT 1800
                                                                   ENVIRONMENT STRAHL_CASES=${cases})
endforeach()
