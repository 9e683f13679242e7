# SPDX-License-Identifier: MIT
strahl_test(bench/test_driver.cpp LABEL device LIBS strahl_bench nlohmann_json::nlohmann_json)
strahl_test(bench/test_race.cpp LABEL device LIBS strahl_bench)
strahl_test(bench/test_mesh_files.cpp LABEL unit LIBS strahl_bench)
strahl_test(bench/test_scene_files.cpp LABEL unit LIBS strahl_bench)
if(EMBREE_INCLUDE AND EMBREE_LIBRARY)
  strahl_test(bench/test_embree.cpp LABEL device LIBS strahl_bench)
endif()
