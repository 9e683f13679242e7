// SPDX-License-Identifier: MIT
// <shape type="spheres">: as many spheres as a PLY file has vertices with a radius, each a shape of its own; to_world
// as for one sphere.
#include "scene/readers/mesh_import.h"
#include "scene/readers/shape_reader.h"

namespace strahl {

Geometry read_spheres(ShapeInput& input) {
  Diagnostics& diagnostics = input.builder.diagnostics;
  const std::optional<std::string> path = data_path(input, "ply");
  const std::optional<Sphere> unit = placed_sphere(Sphere{}, input);
  if (!path || !unit) return Sphere{};
  diagnostics.opened(*path);
  try {
    SphereFile file = read_sphere_file(*path, progress_of(*path, input.builder.mesh_progress));
    diagnostics.append(file.warnings);
    for (Ball& ball : file.spheres) {
      ball.center = input.world_from_object.point(ball.center);
      ball.radius *= unit->radius;
    }
    const Ball first = file.spheres.front();
    file.spheres.erase(file.spheres.begin());
    input.further = std::move(file.spheres);
    return Sphere{first.center, first.radius, unit->frame};
  } catch (const SceneError& fault) {
    diagnostics.append(fault.diagnostics());
    return Sphere{};
  }
}

}  // namespace strahl
