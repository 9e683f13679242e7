# SPDX-License-Identifier: MIT
strahl_test(bench/test_driver.cpp LABEL device LIBS strahl_bench nlohmann_json::nlohmann_json)
strahl_test(bench/test_race.cpp LABEL device LIBS strahl_bench)
strahl_test(bench/test_mesh_files.cpp LABEL unit LIBS strahl_bench)
strahl_test(bench/test_scene_files.cpp LABEL unit LIBS strahl_bench)
if(EMBREE_INCLUDE AND EMBREE_LIBRARY)
  strahl_test(bench/test_embree.cpp LABEL device LIBS strahl_bench)
endif()
strahl_test(bench/test_ten_spheres.cpp LABEL device LIBS strahl_bench)
add_test(NAME bench_test_ten_spheres_long COMMAND bench_tests "-#" "[#test_ten_spheres]")
set_tests_properties(bench_test_ten_spheres_long PROPERTIES LABELS slow TIMEOUT 600 ENVIRONMENT STRAHL_ALL_TIERS=1)
# Half a minute: it builds the generic program.
strahl_test(bench/test_effects.cpp LABEL slow LIBS strahl_bench TIMEOUT 600)
# A minute and a half.
strahl_test(bench/test_ten_million.cpp LABEL slow LIBS strahl_bench SOURCES cli/program.cpp TIMEOUT 1800)
strahl_runs_program(bench_tests)
set_source_files_properties(bench/test_ten_million.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
add_test(NAME bench_test_pictures COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/test_pictures.py $<TARGET_FILE:strahl-bin>)
set_tests_properties(bench_test_pictures PROPERTIES LABELS unit TIMEOUT 60)
