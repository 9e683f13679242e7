# SPDX-License-Identifier: MIT
# The oracle stands apart from libstrahl, which must not need GMP and MPFR.
find_library(GMPXX_LIBRARY gmpxx REQUIRED)
find_library(GMP_LIBRARY gmp REQUIRED)
find_library(MPFR_LIBRARY mpfr REQUIRED)
file(GLOB ORACLE_SOURCES CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/oracle/*.cpp)
add_library(strahl_oracle STATIC ${ORACLE_SOURCES})
target_include_directories(strahl_oracle PUBLIC ${PROJECT_SOURCE_DIR}/src)
target_link_libraries(strahl_oracle PUBLIC ${MPFR_LIBRARY} ${GMPXX_LIBRARY} ${GMP_LIBRARY})

foreach(name exact quadrics planar aabb laws generators)
  strahl_test(oracle/test_${name}.cpp LABEL unit LIBS strahl_oracle)
endforeach()
