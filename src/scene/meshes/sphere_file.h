// SPDX-License-Identifier: MIT
// Spheres by the million: PLY files whose vertices have a radius.
#pragma once

#include <string>
#include <vector>

#include "scene/meshes/mesh_file.h"

namespace strahl {

struct SphereFile {
  std::vector<SphereCloud::Ball> spheres;
  std::vector<Diagnostic> warnings;
};

/// Element vertex with x, y, z and radius, text or binary; other elements and properties are passed over. Throws
/// SceneError where there is none, or one whose numbers are not finite or whose radius is not greater than 0.
[[nodiscard]] SphereFile read_sphere_file(const std::string& path, const MeshProgress& progress = {});

}  // namespace strahl
