# SPDX-License-Identifier: MIT
strahl_test(study/test_stress.cpp LABEL render)
strahl_test(study/test_contact_sheet.cpp LABEL unit)
strahl_test(study/test_generated_scenes.cpp LABEL unit)
strahl_test(study/test_spd.cpp LABEL device)
strahl_test(study/test_ray_sets.cpp LABEL device)
strahl_test(study/test_html_report.cpp LABEL unit LIBS nlohmann_json::nlohmann_json)
