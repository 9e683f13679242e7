// SPDX-License-Identifier: MIT
// <shape type="spheres">: as many spheres as a PLY file has vertices with a radius; to_world as for one sphere.
#include "scene/meshes/sphere_file.h"
#include "scene/readers/mesh_import.h"
#include "scene/readers/shape_reader.h"

namespace strahl {

Geometry read_geometry(ShapeInput& input, const SphereCloud&) {
  Diagnostics& diagnostics = input.builder.diagnostics;
  const std::optional<std::string> path = data_path(input, "ply");
  const std::optional<Sphere> unit = placed_sphere(Sphere{}, input);
  if (!path || !unit) return SphereCloud{};
  diagnostics.opened(*path);
  try {
    SphereFile file = read_sphere_file(*path, progress_of(*path, input.builder.mesh_progress));
    diagnostics.append(file.warnings);
    for (auto& [center, radius] : file.spheres) {
      center = input.world_from_object.point(center);
      radius *= unit->radius;
    }
    return SphereCloud{std::move(file.spheres), unit->frame};
  } catch (const SceneError& fault) {
    diagnostics.append(fault.diagnostics());
    return SphereCloud{};
  }
}

}  // namespace strahl
