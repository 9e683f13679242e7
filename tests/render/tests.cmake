# SPDX-License-Identifier: MIT
foreach(name first_principles large_ground invariance launches closed_form terminator metamorphic mirrors checkerboard
             mirror_box numeric_error accuracy_scenes area_lights many_lights path ao disabled error_coverage
             goals resume several_devices sphere_cloud film filter glass
             ignored_surfaces albedo normals media media_edges media_reach open_media ranked_media grids scattering
             strict_normals panes passing coincident moments last_rays refused without_threads film_parts shared_pixels
             sharing_program)
  strahl_test(render/test_${name}.cpp LABEL render)
endforeach()
strahl_test(render/test_paths_in_lanes.cpp LABEL render LIBS strahl_selftest)
strahl_test(render/test_limitations.cpp LABEL unit)
strahl_test(render/test_error_sums.cpp LABEL unit)
strahl_test(render/test_error_of_few_pixels.cpp LABEL unit)
strahl_test(render/test_film_weights.cpp LABEL unit)
strahl_test(render/test_shared_samples.cpp LABEL unit)
strahl_test(render/test_shared_noise.cpp LABEL unit)
strahl_test(render/test_pass_plan.cpp LABEL unit)
strahl_test(render/test_row_deal.cpp LABEL unit)
strahl_test(render/test_launch_shape.cpp LABEL unit)
strahl_test(render/test_rounding_pilot.cpp LABEL unit)
strahl_test(render/test_prediction.cpp LABEL unit)
strahl_test(render/test_device_film.cpp LABEL unit)
strahl_test(render/test_traversal_choice.cpp LABEL unit)
# A program for every scene, compiled where nothing is cached yet.
strahl_test(render/test_generic.cpp LABEL render TIMEOUT 900)
add_test(NAME render_test_generic_all_tiers COMMAND render_tests "-#" "[#test_generic]")
set_tests_properties(render_test_generic_all_tiers PROPERTIES LABELS slow TIMEOUT 3600 ENVIRONMENT STRAHL_ALL_TIERS=1)
# Where nothing is cached yet, rusticl takes some ten seconds for a stable program.
strahl_test(render/test_devices.cpp LABEL render TIMEOUT 900)
strahl_test(render/test_loop_limit.cpp LABEL render TIMEOUT 300)
strahl_test(render/test_light_tracing.cpp LABEL render TIMEOUT 600)
strahl_test(render/test_lamp_on_surface.cpp LABEL render TIMEOUT 600)
strahl_test(render/test_light_path_limits.cpp LABEL render)
strahl_test(render/test_bidirectional.cpp LABEL render TIMEOUT 600)

add_test(NAME render_test_oclgrind COMMAND ${CMAKE_CURRENT_LIST_DIR}/test_oclgrind $<TARGET_FILE:strahl-bin>
                                           ${PROJECT_SOURCE_DIR}/scenes/lecture/lit.xml ${PROJECT_SOURCE_DIR}/scenes/lecture/first-light.xml)
set_tests_properties(render_test_oclgrind PROPERTIES LABELS oclgrind SKIP_RETURN_CODE 77 TIMEOUT 120)

add_test(NAME render_test_metamorphic_all_scales COMMAND render_tests "-#" "[#test_metamorphic]")
set_tests_properties(render_test_metamorphic_all_scales PROPERTIES LABELS slow TIMEOUT 1800 ENVIRONMENT
                                                                   "STRAHL_ALL_SCALES=1;STRAHL_ALL_TIERS=1")

# 10,000 rays x 10,000 mirrors for every room and tier: about half an hour.
add_test(NAME render_test_mirror_box_long COMMAND render_tests "-#" "[#test_mirror_box]")
set_tests_properties(render_test_mirror_box_long PROPERTIES LABELS slow TIMEOUT 7200 ENVIRONMENT
                                                                             "STRAHL_MIRRORS=10000;STRAHL_ALL_TIERS=1")
strahl_test(render/test_every_scene.cpp LABEL slow TIMEOUT 10800)

file(GLOB_RECURSE every_scene CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/scenes/*.xml)
add_test(NAME render_test_oclgrind_every_scene COMMAND ${CMAKE_CURRENT_LIST_DIR}/test_oclgrind $<TARGET_FILE:strahl-bin>
                                                       ${every_scene})
set_tests_properties(render_test_oclgrind_every_scene PROPERTIES LABELS slow SKIP_RETURN_CODE 77 TIMEOUT 3600)

foreach(name closed_form albedo ao area_lights checkerboard coincident glass grids large_ground mirror_box mirrors terminator)
  add_test(NAME render_test_${name}_all_tiers COMMAND render_tests "-#" "[#test_${name}]")
  set_tests_properties(render_test_${name}_all_tiers PROPERTIES LABELS slow TIMEOUT 1200 ENVIRONMENT STRAHL_ALL_TIERS=1)
endforeach()

foreach(name grids media ranked_media)
  add_test(NAME render_test_${name}_own_programs COMMAND render_tests "-#" "[#test_${name}]")
  set_tests_properties(render_test_${name}_own_programs PROPERTIES LABELS slow TIMEOUT 1200 ENVIRONMENT
                                                                                     STRAHL_OWN_PROGRAMS=1)
endforeach()

add_test(NAME render_test_paths_in_lanes_long COMMAND render_tests "-#" "[#test_paths_in_lanes]")
set_tests_properties(render_test_paths_in_lanes_long PROPERTIES LABELS slow TIMEOUT 3600 ENVIRONMENT
                                                                         "STRAHL_LANES=long;STRAHL_OWN_PROGRAMS=1")

add_test(NAME render_test_error_coverage_long COMMAND render_tests "-#" "[#test_error_coverage]")
set_tests_properties(
  render_test_error_coverage_long PROPERTIES LABELS slow TIMEOUT 14400 ENVIRONMENT STRAHL_COVERAGE=long)

add_test(NAME render_test_bidirectional_long COMMAND render_tests "-#" "[#test_bidirectional]")
set_tests_properties(
  render_test_bidirectional_long PROPERTIES LABELS slow TIMEOUT 14400 ENVIRONMENT STRAHL_AGREEMENT=long)

add_test(NAME render_test_scattering_long COMMAND render_tests "-#" "[#test_scattering]")
set_tests_properties(render_test_scattering_long PROPERTIES LABELS slow TIMEOUT 14400 ENVIRONMENT
                                                                                      STRAHL_SCATTERING=long)
# 10^7 walks of each body.
add_test(NAME render_test_media_edges_long COMMAND render_tests "M07*")
set_tests_properties(render_test_media_edges_long PROPERTIES LABELS slow TIMEOUT 7200 ENVIRONMENT STRAHL_WALKS=1e7)
