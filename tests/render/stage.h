// SPDX-License-Identifier: MIT
// A bare scene for closed forms: an orthographic camera looks down -z from z = 4 at the square |x|, |y| < 2; one sample
// through each pixel's middle.
#pragma once

#include <numbers>

#include "render/pictures.h"
#include "scene/model/build.h"

namespace strahl::test {

inline constexpr int stage_size = 48;
inline constexpr double half_width = 2;

inline Scene stage(const std::vector<Geometry>& shapes, const Material& material = {}) {
  Scene scene;
  scene.materials = {material};
  for (const Geometry& geometry : shapes) {
    scene.shapes.emplace_back();
    scene.shapes.back().geometry = geometry;
  }
  scene.camera.projection = Projection::orthographic;
  scene.camera.world_from_camera.m = {{{-half_width, 0, 0, 0}, {0, half_width, 0, 0}, {0, 0, -1, 4}}};
  scene.film.width = scene.film.height = stage_size;
  scene.sampler.kind = SamplerKind::centre;
  scene.sampler.sample_count = 1;
  return scene;
}

inline Material diffuse(const Rgb& reflectance, bool twosided = false) {
  Material material;
  material.bsdf = Diffuse{{reflectance}};
  material.twosided = twosided;
  return material;
}

inline Plane floor_plane() { return {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}}; }

template <typename Emitter>
Light light(const Emitter& emitter) {
  Light light;
  light.emitter = emitter;
  return light;
}

/// A lamp with a slanted edge near x = -0.3, looked at directly.
inline Scene lamp_edge(int samples) {
  Scene scene = stage({});
  add(scene, emitting(Rectangle{{-0.3, -9, 0}, {9, 1, 0}, {0, 18, 0}}, {1, 2, 3}));
  scene.integrator.name = "emission";
  scene.sampler.kind = SamplerKind::sobol;
  scene.sampler.sample_count = samples;
  return scene;
}

/// Where the ray of a pixel runs.
inline double stage_x(int column) { return half_width * (2 * column + 1 - stage_size) / stage_size; }
inline double stage_y(int row) { return -half_width * (2 * row + 1 - stage_size) / stage_size; }

inline RenderSettings stage_settings(Precision precision) {
  RenderSettings settings = generic_settings(precision);
  settings.aovs = all_aovs().aovs;
  return settings;
}

inline RenderResult stage_picture(const Scene& scene, Precision precision, const std::set<std::string>& disabled = {}) {
  RenderSettings settings = stage_settings(precision);
  settings.disabled = disabled;
  return render("pocl", scene, settings);
}

inline Image color(const Scene& scene, Precision precision = Precision::robust) {
  return stage_picture(scene, precision).color;
}

}  // namespace strahl::test
