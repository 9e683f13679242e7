# SPDX-License-Identifier: MIT
# What the laws of light say of cl/lights and cl/areas, on the host, apart from libstrahl, whose headers have the same
# names: only cl/ and tests/ are on the path. STRAHL_HOST_HAS_FMA: tests/cl/tests.cmake.
add_library(strahl_host_lights STATIC physics/lights_f32.cpp physics/lights_f64.cpp)
# One dialect, several tiers: each file is a world of its own.
set_target_properties(strahl_host_lights PROPERTIES UNITY_BUILD OFF)
target_include_directories(strahl_host_lights PRIVATE ${PROJECT_SOURCE_DIR}/cl ${CMAKE_CURRENT_SOURCE_DIR})
# Enumerators of the lists are flags to C.
target_compile_options(strahl_host_lights PRIVATE -O2 -Wno-psabi -Wno-int-in-bool-context -Wno-deprecated-enum-enum-conversion $<$<BOOL:${STRAHL_HOST_HAS_FMA}>:-mfma>)

foreach(name light_numbers)
  strahl_test(physics/test_${name}.cpp LABEL unit LIBS strahl_host_lights)
endforeach()

# cl/materials in every tier and width.
add_library(strahl_host_bsdfs STATIC physics/bsdfs_stable.cpp physics/bsdfs_robust.cpp physics/bsdfs_double.cpp)
set_target_properties(strahl_host_bsdfs PROPERTIES UNITY_BUILD OFF)
target_include_directories(strahl_host_bsdfs PRIVATE ${PROJECT_SOURCE_DIR}/cl ${CMAKE_CURRENT_SOURCE_DIR})
target_compile_options(strahl_host_bsdfs PRIVATE -O1 -Wno-psabi $<$<BOOL:${STRAHL_HOST_HAS_FMA}>:-mfma>)

foreach(name materials microfacets principled older_materials fresnel mitsuba_bsdfs)
  strahl_test(physics/test_${name}.cpp LABEL unit LIBS strahl_host_bsdfs)
endforeach()

# cl/lights, areas, choosers, textures, packets and integrators in every tier.
add_library(strahl_host_transport STATIC physics/transport_fast.cpp physics/transport_stable.cpp
            physics/transport_robust.cpp physics/transport_double.cpp
            physics/transport_media.cpp)
set_target_properties(strahl_host_transport PROPERTIES UNITY_BUILD OFF)
target_include_directories(strahl_host_transport PRIVATE ${PROJECT_SOURCE_DIR}/cl ${CMAKE_CURRENT_SOURCE_DIR})
# -Wno-maybe-uninitialized: a ray's way back from an instance is there only where it has gone into one.
target_compile_options(strahl_host_transport PRIVATE -O1 -Wno-psabi -Wno-int-in-bool-context -Wno-enum-compare
                       -Wno-deprecated-enum-enum-conversion -Wno-maybe-uninitialized
                       $<$<BOOL:${STRAHL_HOST_HAS_FMA}>:-mfma>)

foreach(name areas chosen_items blends coats reliefs sun lights lights_alike choosers textures environment mitsuba_images mitsuba_lights integrators)
  strahl_test(physics/test_${name}.cpp LABEL unit LIBS strahl_host_transport)
endforeach()
strahl_test(physics/test_flipped_indices.cpp LABEL unit LIBS strahl_host_transport)
add_test(NAME physics_test_flipped_indices_all COMMAND physics_tests "-#" "[#test_flipped_indices]")
set_tests_properties(physics_test_flipped_indices_all PROPERTIES LABELS slow TIMEOUT 14400 ENVIRONMENT STRAHL_ALL_FLIPS=1)
foreach(name materials integrators)
  add_test(NAME physics_test_${name}_all_widths COMMAND physics_tests "-#" "[#test_${name}]")
  set_tests_properties(physics_test_${name}_all_widths PROPERTIES LABELS slow TIMEOUT 1200 ENVIRONMENT STRAHL_ALL_WIDTHS=1)
endforeach()
strahl_test(physics/test_packets.cpp LABEL unit LIBS strahl_host_transport strahl_selftest)

# Names of their own mean something else in each.
set_source_files_properties(physics/test_microfacets.cpp physics/test_principled.cpp physics/test_older_materials.cpp physics/test_mitsuba_bsdfs.cpp physics/test_mitsuba_lights.cpp physics/test_coats.cpp physics/test_sun.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
