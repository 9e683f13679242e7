# SPDX-License-Identifier: MIT
strahl_test(selftest/test_probe.cpp LABEL device LIBS strahl_robust_kernels strahl_selftest)
# Bodies of the tiers on the host, apart from libstrahl, whose headers have the same names: only cl/ and tests/ on the
# path. STRAHL_HOST_HAS_FMA: tests/cl/tests.cmake, which comes first.
add_library(strahl_nearest STATIC selftest/nearest_stable.cpp selftest/nearest_robust.cpp selftest/nearest_double.cpp)
set_target_properties(strahl_nearest PROPERTIES UNITY_BUILD OFF)
target_include_directories(strahl_nearest PRIVATE ${PROJECT_SOURCE_DIR}/cl ${CMAKE_CURRENT_SOURCE_DIR})
target_compile_options(strahl_nearest PRIVATE -O2 -Wno-psabi $<$<BOOL:${STRAHL_HOST_HAS_FMA}>:-mfma>)

add_executable(strahl_answer_rows selftest/answer_rows.cpp)
target_link_libraries(strahl_answer_rows PRIVATE strahl_selftest fmt::fmt)

strahl_test(selftest/test_proofs.cpp LABEL unit LIBS strahl_selftest)
strahl_test(selftest/test_catalogue.cpp LABEL unit LIBS strahl_selftest fmt::fmt)
strahl_test(selftest/test_catalogue_host.cpp LABEL unit LIBS strahl_selftest strahl_nearest)
strahl_test(selftest/test_catalogue_devices.cpp LABEL device LIBS strahl_selftest)
strahl_test(selftest/test_catalogue_pictures.cpp LABEL render LIBS strahl_selftest)

strahl_test(selftest/test_faults.cpp LABEL device SOURCES cli/program.cpp LIBS strahl_selftest nlohmann_json::nlohmann_json
            TIMEOUT 300)
strahl_runs_program(selftest_tests)
set_source_files_properties(selftest/test_faults.cpp selftest/test_catalogue_pictures.cpp
                            PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
