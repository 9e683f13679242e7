# SPDX-License-Identifier: MIT
# `cmake --install`: the program, and the library with its headers and the package that find_package(strahl) reads.
include(CMakePackageConfigHelpers)

install(TARGETS strahl-bin RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS strahl EXPORT strahl ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(
  DIRECTORY src/
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/strahl
  FILES_MATCHING
  PATTERN "*.h"
  PATTERN cli EXCLUDE
  PATTERN oracle EXCLUDE)

set(STRAHL_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/strahl)
install(EXPORT strahl NAMESPACE strahl:: FILE strahlTargets.cmake DESTINATION ${STRAHL_PACKAGE_DIR})
configure_package_config_file(src/strahlConfig.cmake.in ${PROJECT_BINARY_DIR}/strahlConfig.cmake
                              INSTALL_DESTINATION ${STRAHL_PACKAGE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/strahlConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/strahlConfig.cmake ${PROJECT_BINARY_DIR}/strahlConfigVersion.cmake
        DESTINATION ${STRAHL_PACKAGE_DIR})
