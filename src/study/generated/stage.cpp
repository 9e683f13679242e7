// SPDX-License-Identifier: MIT
#include "study/generated/stage.h"

#include <numbers>

namespace strahl {

Vec3 to_float(const Vec3& v) {
  const auto rounded = [](double x) { return static_cast<double>(static_cast<float>(x)); };
  return {rounded(v.x), rounded(v.y), rounded(v.z)};
}

Scene stage(const std::string& name, const Vec3& camera, const Vec3& target, const Vec3& up, double fov_degrees,
            const Vec3& lamp) {
  Scene scene;
  scene.name = name;
  const Vec3 forward = normalized(target - camera);
  const Vec3 left = normalized(cross(up, forward));
  const Vec3 top = cross(forward, left);
  scene.camera.world_from_camera = Transform{{{{left.x, top.x, forward.x, camera.x},
                                               {left.y, top.y, forward.y, camera.y},
                                               {left.z, top.z, forward.z, camera.z}}}};
  scene.camera.fov_degrees = fov_degrees;
  scene.film.width = scene.film.height = 1024;
  scene.film.filter.kind = FilterKind::box;
  scene.sampler.kind = SamplerKind::centre;
  scene.sampler.sample_count = 1;
  scene.materials[0].twosided = true;
  const double distance = length(target - lamp);
  const double intensity = std::numbers::pi * distance * distance;
  scene.lights.push_back({"", PointLight{lamp, {intensity, intensity, intensity}}, {}});
  return scene;
}

}  // namespace strahl
