# SPDX-License-Identifier: MIT
# The robust tier on the host, apart from libstrahl, whose headers have the same names: only cl/ and tests/ on the path.
# STRAHL_HOST_HAS_FMA: tests/cl/tests.cmake, which comes first.
add_library(strahl_robust_kernels STATIC robust/routes.cpp robust/kernels_double_words.cpp robust/kernels_doubles.cpp
                                         robust/kernels_exact.cpp)
set_source_files_properties(robust/kernels_double_words.cpp robust/kernels_doubles.cpp robust/kernels_exact.cpp
                            PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
target_include_directories(strahl_robust_kernels PRIVATE ${PROJECT_SOURCE_DIR}/cl ${CMAKE_CURRENT_SOURCE_DIR})
target_compile_options(strahl_robust_kernels PRIVATE -O2 -Wno-psabi $<$<BOOL:${STRAHL_HOST_HAS_FMA}>:-mfma>)

strahl_test(robust/test_oracle.cpp LABEL unit LIBS strahl_robust_kernels strahl_selftest)
strahl_test(robust/test_rounding.cpp LABEL unit LIBS strahl_robust_kernels strahl_selftest)
strahl_test(robust/test_decisions.cpp LABEL unit LIBS strahl_robust_kernels strahl_selftest)
strahl_test(robust/test_departed.cpp LABEL unit LIBS strahl_robust_kernels strahl_selftest)
strahl_test(robust/test_balls.cpp LABEL unit LIBS strahl_robust_kernels strahl_selftest)
strahl_test(robust/test_devices.cpp LABEL device LIBS strahl_robust_kernels strahl_selftest TIMEOUT 300)
strahl_test(robust/test_edges_devices.cpp LABEL device LIBS strahl_selftest)

# A million cases a law: minutes.
add_test(NAME robust_test_oracle_million COMMAND robust_tests "-#" "[#test_oracle]")
set_tests_properties(robust_test_oracle_million PROPERTIES LABELS slow TIMEOUT 3600 ENVIRONMENT STRAHL_CASES=1000000)
