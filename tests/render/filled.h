// SPDX-License-Identifier: MIT
// Shapes full of a medium, in white surroundings.
#pragma once

#include <catch2/catch.hpp>

#include "render/stage.h"
#include "support/asked.h"

namespace strahl::test {

/// Of a surface that is nothing but the boundary of a medium.
inline Material boundary() {
  Material null;
  null.opacity = Reflectance{{0, 0, 0}};
  return null;
}

/// A wide slab from z = -depth / 2 to depth / 2, or a ball, in white surroundings.
inline Scene filled(const Geometry& geometry, const Medium& medium, double around = 1) {
  Scene scene = stage({geometry}, boundary());
  scene.media = {medium};
  scene.shapes.front().media = MediumBoundary{0, -1};
  scene.integrator.name = "volpath";
  scene.lights = {light(ConstantLight{{around, around, around}})};
  return scene;
}

inline Cube slab(double depth) { return {{-100, -100, -0.5 * depth}, {{{200, 0, 0}, {0, 200, 0}, {0, 0, depth}}}}; }

/// A closed mesh of twelve triangles.
inline Mesh block(const Vec3& low, const Vec3& high) {
  Mesh mesh;
  for (unsigned i = 0; i < 8; ++i)
    mesh.positions.push_back(
        {(i & 1U) != 0 ? high.x : low.x, (i & 2U) != 0 ? high.y : low.y, (i & 4U) != 0 ? high.z : low.z});
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

inline Medium medium(const Rgb& sigma_t, const Rgb& albedo) {
  Medium medium;
  medium.sigma_t = sigma_t;
  medium.albedo = albedo;
  return medium;
}

inline Rgb mean_of(const Image& image) {
  Rgb sum{0, 0, 0};
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      sum.r += static_cast<double>(image.at(x, y, 0));
      sum.g += static_cast<double>(image.at(x, y, 1));
      sum.b += static_cast<double>(image.at(x, y, 2));
    }
  const double n = image.width * image.height;
  return {sum.r / n, sum.g / n, sum.b / n};
}

inline Image drawn(Scene scene, int samples) {
  scene.sampler.kind = SamplerKind::independent;
  scene.sampler.sample_count = samples;
  return color(scene, Precision::robust);
}

/// Paths are the same one by one and in lanes by the programs with every effect; in_own_too, and with
/// STRAHL_OWN_PROGRAMS: by those of the scene's own as well.
inline void check_in_lanes(Scene scene, bool in_own_too = !asks_generic()) {
  scene.film.width = scene.film.height = 16;
  scene.sampler.kind = SamplerKind::sobol;
  scene.sampler.sample_count = 32;
  RenderSettings settings = generic_settings();
  const RenderResult lanes = render("pocl", scene, settings);
  settings.paths_in_lanes = false;
  CHECK(same_bits(lanes, render("pocl", scene, settings)));
  if (!in_own_too) return;
  settings.generic = false;
  CHECK(same_bits(lanes, render("pocl", scene, settings)));
  settings.paths_in_lanes = true;
  CHECK(same_bits(lanes, render("pocl", scene, settings)));
}

/// What only scatters is not seen in white surroundings.
inline void check_unseen(const Medium& white) {
  const Rgb mean = mean_of(drawn(filled(Sphere{{0, 0, 0}, 1}, white), 64));
  CHECK(mean.r == Approx(1).margin(4e-3));
  CHECK(mean.g == Approx(1).margin(4e-3));
  CHECK(mean.b == Approx(1).margin(6e-3));
}

}  // namespace strahl::test
