# SPDX-License-Identifier: MIT
strahl_test(study/test_stress.cpp LABEL render)
strahl_test(study/test_contact_sheet.cpp LABEL unit)
strahl_test(study/test_generated_scenes.cpp LABEL unit)
strahl_test(study/test_spd.cpp LABEL device)
strahl_test(study/test_effect_costs.cpp LABEL device)
strahl_test(study/test_ray_sets.cpp LABEL device)
strahl_test(study/test_html_report.cpp LABEL unit LIBS nlohmann_json::nlohmann_json)
# The report in a browser, a minute: exit 77 without Debian's chromium, chromium-driver and python3-selenium.
add_executable(study_sample_report ${CMAKE_CURRENT_LIST_DIR}/sample_report.cpp)
target_link_libraries(study_sample_report PRIVATE strahl nlohmann_json::nlohmann_json)
find_program(DEBIAN_PYTHON python3 HINTS /usr/bin)
add_test(NAME study_report_browser COMMAND ${DEBIAN_PYTHON} -B ${CMAKE_CURRENT_LIST_DIR}/report_browser.py
                                           $<TARGET_FILE:study_sample_report>)
set_tests_properties(study_report_browser PROPERTIES LABELS slow SKIP_RETURN_CODE 77 TIMEOUT 900)
foreach(name tradeoff_numbers tradeoff_plan)
  strahl_test(study/test_${name}.cpp LABEL unit)
endforeach()
strahl_test(study/test_tradeoff.cpp LABEL render LIBS nlohmann_json::nlohmann_json)
