// SPDX-License-Identifier: MIT
#include "packing/pack_camera.h"

#include <cmath>

#include "packing/cl_layout.h"
#include "packing/pack.h"
#include "scene/model/framing.h"

namespace strahl {
std::vector<double> camera_reals(const Camera& camera, const Film& film, const UploadFrame& frame) {
  const Transform& world = camera.world_from_camera;
  const Vec3 forward = world.column(2);
  // A distance along the viewing axis is 1 in t: directions are given per unit of depth.
  const double depth = 1 / length(forward);
  const Vec3 right = -(world.column(0)), down = -(world.column(1));
  const double aspect = static_cast<double>(film.height) / film.width;

  Vec3 o = frame.point(world.translation()), ox, oy, d = depth * forward, dx, dy;
  if (camera.projection == Projection::perspective) {
    const double tangent = tan_half_width(camera.fov_degrees, camera.fov_axis, film.width, film.height);
    dx = (tangent * depth) * right;
    dy = (tangent * aspect * depth) * down;
    d = d + 2 * camera.principal_point_offset_x * dx + 2 * camera.principal_point_offset_y * dy;
  } else {
    ox = frame.vector(right);
    oy = frame.vector(aspect * down);
  }
  std::vector<double> reals(layout::CAMERA_REALS, 0.0);
  auto put = [&](int at, const Vec3& v) {
    reals[static_cast<std::size_t>(at)] = v.x;
    reals[static_cast<std::size_t>(at + 1)] = v.y;
    reals[static_cast<std::size_t>(at + 2)] = v.z;
  };
  put(layout::CAMERA_O, o);
  put(layout::CAMERA_OX, ox);
  put(layout::CAMERA_OY, oy);
  put(layout::CAMERA_D, d);
  put(layout::CAMERA_DX, dx);
  put(layout::CAMERA_DY, dy);
  const double radius = camera.aperture_radius;
  if (radius > 0) {
    put(layout::CAMERA_LENS_U, frame.vector(radius * normalized(right)));
    put(layout::CAMERA_LENS_V, frame.vector(radius * normalized(down)));
    reals[layout::CAMERA_FOCUS] = 1 / (frame.scale * camera.focus_distance);
  }
  reals[layout::CAMERA_NEAR] = frame.scale * camera.near_clip;
  reals[layout::CAMERA_FAR] = frame.scale * camera.far_clip;
  return reals;
}

std::vector<double> camera_reals(const Scene& scene, SamplerKind sampler, const UploadFrame& frame) {
  Camera camera = scene.camera;
  if (sampler == SamplerKind::centre) camera.aperture_radius = 0;
  return camera_reals(camera, scene.film, frame);
}

std::vector<double> sensor_reals(const Camera& camera, const Film& film, const UploadFrame& frame) {
  const std::vector<double> reals = camera_reals(camera, film, frame);
  const auto vector_at = [&](int at) {
    const auto k = static_cast<std::size_t>(at);
    return Vec3{reals[k], reals[k + 1], reals[k + 2]};
  };
  const bool spreads = camera.projection == Projection::perspective;
  const Vec3 d = vector_at(layout::CAMERA_D), x = vector_at(spreads ? layout::CAMERA_DX : layout::CAMERA_OX);
  const Vec3 y = vector_at(spreads ? layout::CAMERA_DY : layout::CAMERA_OY), across = cross(x, y);
  const double volume = dot(d, across);
  std::vector<double> sensor;
  for (const Vec3& row : {across, cross(y, d), cross(d, x)})
    for (const double component : {row.x, row.y, row.z}) sensor.push_back(component / volume);
  const FilterDensities filter = filter_densities(film.filter);
  sensor.insert(sensor.end(), {1 / (4 * std::fabs(volume)), spreads ? 1.0 : 0.0, static_cast<double>(film.height),
                               filter.half_width});
  sensor.insert(sensor.end(), filter.values.begin(), filter.values.end());
  return sensor;
}

}  // namespace strahl
