# SPDX-License-Identifier: MIT
# The robust tier on the host, apart from libstrahl, whose headers have the same names: only cl/ and tests/ on the path.
# Without the instruction every fma is a library call, right but ten times slower; it is used where this machine has it.
include(CheckCXXSourceRuns)
set(CMAKE_REQUIRED_FLAGS -mfma)
check_cxx_source_runs(
  "#include <cmath>
   int main() { volatile double a = 1; return std::fma(a, a, -a) == 0 ? 0 : 1; }" STRAHL_HOST_HAS_FMA)
unset(CMAKE_REQUIRED_FLAGS)
add_library(strahl_robust_kernels STATIC robust/kernels.cpp)
target_include_directories(strahl_robust_kernels PRIVATE ${PROJECT_SOURCE_DIR}/cl ${CMAKE_CURRENT_SOURCE_DIR})
target_compile_options(strahl_robust_kernels PRIVATE -O2 -Wno-psabi $<$<BOOL:${STRAHL_HOST_HAS_FMA}>:-mfma>)

strahl_test(robust/test_oracle.cpp LABEL unit LIBS strahl_robust_kernels strahl_oracle)
strahl_test(robust/test_departed.cpp LABEL unit LIBS strahl_robust_kernels strahl_oracle)
strahl_test(robust/test_devices.cpp LABEL device LIBS strahl_robust_kernels strahl_oracle TIMEOUT 300)

# A million cases a law: minutes.
add_test(NAME robust_test_oracle_million COMMAND robust_test_oracle "[million]")
set_tests_properties(robust_test_oracle_million PROPERTIES LABELS slow TIMEOUT 3600)
