# SPDX-License-Identifier: MIT
# `cmake --install`: the program, and the library with its headers and the package that find_package(strahl) reads.
include(CMakePackageConfigHelpers)

install(TARGETS strahl-bin RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
# strahl.h and what it includes; everything else is internal.
target_sources(
  strahl
  PUBLIC FILE_SET
         HEADERS
         BASE_DIRS
         src
         FILES
         src/strahl.h
         src/errors.h
         src/opencl/device.h
         src/opencl/opencl.h
         src/image/channel.h
         src/image/flip.h
         src/image/image.h
         src/image/image_io.h
         src/image/metrics.h
         src/image/npy.h
         src/image/texels.h
         src/render/error_budget.h
         src/render/error_estimate.h
         src/render/goal.h
         src/render/intersector.h
         src/render/renderer.h
         src/settings/aov_list.h
         src/settings/sampling.h
         src/settings/settings.h
         src/render/stats.h
         src/render/unusual_samples.h
         src/packing/memory_need.h
         src/packing/tree_stats.h
         src/trust/tier_choice.h
         src/trust/tier_verdict.h
         src/scene/model/aovs.h
         src/scene/model/build.h
         src/scene/loader.h
         src/scene/meshes/mesh_file.h
         src/scene/meshes/mesh_material.h
         src/scene/model/materials.h
         src/scene/model/media.h
         src/scene/model/scene.h
         src/scene/validate.h
         src/scene/model/vec.h
         src/scene/model/volume.h)
install(
  TARGETS strahl
  EXPORT strahl
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/strahl)

set(STRAHL_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/strahl)
install(EXPORT strahl NAMESPACE strahl:: FILE strahlTargets.cmake DESTINATION ${STRAHL_PACKAGE_DIR})
configure_package_config_file(src/strahlConfig.cmake.in ${PROJECT_BINARY_DIR}/strahlConfig.cmake
                              INSTALL_DESTINATION ${STRAHL_PACKAGE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/strahlConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/strahlConfig.cmake ${PROJECT_BINARY_DIR}/strahlConfigVersion.cmake
        DESTINATION ${STRAHL_PACKAGE_DIR})
