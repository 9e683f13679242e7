# SPDX-License-Identifier: MIT
foreach(name ignis_point sionna embree_masks)
  strahl_test(acceptance/test_${name}.cpp LABEL render)
endforeach()

# Needs a python3 with mitsuba and numpy (PyPI).
add_test(NAME acceptance_mitsuba_geometry
         COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/mitsuba_geometry.py $<TARGET_FILE:strahl-bin> 20)
set_tests_properties(acceptance_mitsuba_geometry PROPERTIES LABELS slow SKIP_RETURN_CODE 77 TIMEOUT 900)

add_test(NAME acceptance_mitsuba_watertight
         COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/mitsuba_watertight.py $<TARGET_FILE:strahl-bin> 20000)
set_tests_properties(acceptance_mitsuba_watertight PROPERTIES LABELS slow SKIP_RETURN_CODE 77 TIMEOUT 900)

add_test(NAME acceptance_mitsuba_glass
         COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/mitsuba_glass.py $<TARGET_FILE:strahl-bin>)
set_tests_properties(acceptance_mitsuba_glass PROPERTIES LABELS slow SKIP_RETURN_CODE 77 TIMEOUT 1800)
add_test(NAME acceptance_mitsuba_bsdfs COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/mitsuba_bsdfs.py --check)
set_tests_properties(acceptance_mitsuba_bsdfs PROPERTIES LABELS slow SKIP_RETURN_CODE 77 TIMEOUT 300)
add_test(NAME acceptance_mitsuba_reliefs COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/mitsuba_reliefs.py --check)
set_tests_properties(acceptance_mitsuba_reliefs PROPERTIES LABELS slow SKIP_RETURN_CODE 77 TIMEOUT 300)
add_test(NAME acceptance_mitsuba_lights COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/mitsuba_lights.py --check)
set_tests_properties(acceptance_mitsuba_lights PROPERTIES LABELS slow SKIP_RETURN_CODE 77 TIMEOUT 300)
add_test(NAME acceptance_mitsuba_indices COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/mitsuba_indices.py --check)
set_tests_properties(acceptance_mitsuba_indices PROPERTIES LABELS slow SKIP_RETURN_CODE 77 TIMEOUT 300)
add_test(NAME acceptance_mitsuba_path
         COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/mitsuba_path.py $<TARGET_FILE:strahl-bin>)
set_tests_properties(acceptance_mitsuba_path PROPERTIES LABELS slow SKIP_RETURN_CODE 77 TIMEOUT 1800)

add_test(NAME acceptance_mitsuba_images
         COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/mitsuba_images.py $<TARGET_FILE:strahl-bin>)
set_tests_properties(acceptance_mitsuba_images PROPERTIES LABELS slow SKIP_RETURN_CODE 77 TIMEOUT 1800)

# What lies at the heart of materials on every carrier; all of them are slow. Python alone.
add_test(NAME acceptance_pictures_few
         COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/mitsuba_pictures.py $<TARGET_FILE:strahl-bin> roughconductor roughconductor-textured carriers)
set_tests_properties(acceptance_pictures_few PROPERTIES LABELS render TIMEOUT 300)
add_test(NAME acceptance_pictures
         COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/mitsuba_pictures.py $<TARGET_FILE:strahl-bin>)
set_tests_properties(acceptance_pictures PROPERTIES LABELS slow TIMEOUT 3600)
add_test(NAME acceptance_mitsuba_pictures COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/mitsuba_pictures.py --check)
set_tests_properties(acceptance_mitsuba_pictures PROPERTIES LABELS slow SKIP_RETURN_CODE 77 TIMEOUT 3600)

# Needs a python3 with scikit-image and flip-evaluator (PyPI).
add_test(NAME acceptance_metrics_peers
         COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/metrics_peers.py $<TARGET_FILE:strahl-bin>)
set_tests_properties(acceptance_metrics_peers PROPERTIES LABELS slow SKIP_RETURN_CODE 77 TIMEOUT 300)

# Names of their own mean something else in each.
set_source_files_properties(acceptance/test_sionna.cpp acceptance/test_embree_masks.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
