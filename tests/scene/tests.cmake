# SPDX-License-Identifier: MIT
foreach(test vec transform elements shapes faults unknowns expansion validate scenes)
  strahl_test(scene/test_${test}.cpp LABEL unit)
endforeach()
# Brings its own main, to exit with 77 where ../shared is absent.
add_executable(scene_test_shared_scenes scene/test_shared_scenes.cpp)
target_link_libraries(scene_test_shared_scenes PRIVATE Catch2::Catch2 strahl)
target_compile_definitions(scene_test_shared_scenes PRIVATE STRAHL_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
add_test(NAME scene_test_shared_scenes COMMAND scene_test_shared_scenes)
set_tests_properties(scene_test_shared_scenes PROPERTIES LABELS unit SKIP_RETURN_CODE 77 TIMEOUT 120)
strahl_test(scene/test_fuzz.cpp LABEL fuzz)
