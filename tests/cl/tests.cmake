# SPDX-License-Identifier: MIT
strahl_test(cl/test_angle.cpp LABEL unit LIBS strahl_oracle SOURCES cl/angle_f32.cpp cl/angle_f64.cpp)
set_source_files_properties(cl/test_exp_log.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
set_source_files_properties(cl/test_angle.cpp cl/angle_f32.cpp cl/angle_f64.cpp cl/test_departure.cpp
                            cl/test_near_point.cpp
                            PROPERTIES INCLUDE_DIRECTORIES ${PROJECT_SOURCE_DIR}/cl)

# The dialect on the host. Apart from libstrahl, whose headers have the same names: only cl/ and tests/ are on the path.
# Without the instruction every fma is a library call, right but ten times slower; it is used where this machine has it.
include(CheckCXXSourceRuns)
set(CMAKE_REQUIRED_FLAGS -mfma)
check_cxx_source_runs(
  "#include <cmath>
   int main() { volatile double a = 1; return std::fma(a, a, -a) == 0 ? 0 : 1; }" STRAHL_HOST_HAS_FMA)
unset(CMAKE_REQUIRED_FLAGS)
add_library(strahl_host_kernels STATIC cl/host_kernels_f32.cpp cl/host_kernels_f64.cpp cl/math_f32.cpp cl/math_f64.cpp
            cl/pixel_samples_f32.cpp cl/pixel_samples_f64.cpp cl/sampling_f32.cpp cl/sampling_f64.cpp)
# One dialect, two precisions: each file is a world of its own.
set_target_properties(strahl_host_kernels PROPERTIES UNITY_BUILD OFF)
target_include_directories(strahl_host_kernels PRIVATE ${PROJECT_SOURCE_DIR}/cl ${CMAKE_CURRENT_SOURCE_DIR})
# -O2 in every configuration: these bodies are what the tests below spend their time in.
target_compile_options(strahl_host_kernels PRIVATE -O2 -Wno-psabi $<$<BOOL:${STRAHL_HOST_HAS_FMA}>:-mfma>)

strahl_test(cl/test_departure.cpp LABEL unit)
strahl_test(cl/test_near_point.cpp LABEL unit)
foreach(name departed exp_log film math pixel_samples samplers sampling soft_fma splat)
  strahl_test(cl/test_${name}.cpp LABEL unit LIBS strahl_host_kernels strahl_oracle)
endforeach()
add_test(NAME cl_test_exp_log_all COMMAND cl_tests "-#" "[#test_exp_log]")
set_tests_properties(cl_test_exp_log_all PROPERTIES LABELS slow TIMEOUT 1800 ENVIRONMENT STRAHL_CASES=1000000)
foreach(name shapes_oracle watertight ties arbitrary_bits host_equals_device)
  strahl_test(cl/test_${name}.cpp LABEL device LIBS strahl_host_kernels strahl_selftest TIMEOUT 600)
endforeach()
strahl_test(cl/test_rusticl_widths.cpp LABEL device slow LIBS strahl_host_kernels strahl_selftest TIMEOUT 3000)
