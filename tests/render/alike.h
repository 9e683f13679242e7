// SPDX-License-Identifier: MIT
// Two integrators make the same picture: means of its blocks over several seeds, by Welch's test. One makes it with the
// same bits however it is asked. And scenes of a ball.
#pragma once

#include <catch2/catch.hpp>
#include <cmath>

#include "render/stage.h"
#include "scene/model/build.h"

namespace strahl::test {

inline constexpr int block_picture = 32, blocks = 4, block_seeds = 8;

/// Each block's mean over all seeds, and its standard error.
struct Blocks {
  std::vector<double> mean, error;
};

inline Blocks blocks_of(Scene scene, const std::string& integrator, int samples) {
  scene.integrator.name = integrator;
  scene.film.width = scene.film.height = block_picture;
  static const Device device = Device::open("pocl");
  Renderer renderer(device, scene, generic_settings());
  constexpr std::size_t count = blocks * blocks;
  std::vector<double> sum(count), squares(count);
  for (std::uint32_t seed = 0; seed < block_seeds; ++seed) {
    RenderGoal goal;
    goal.spp = samples;
    goal.seed = 7 + seed;
    const Image image = renderer.render({}, goal).color;
    std::vector<double> block(count);
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        for (int c = 0; c < 3; ++c)
          block[static_cast<std::size_t>(y * blocks / image.height * blocks + x * blocks / image.width)] +=
              static_cast<double>(image.at(x, y, c)) * blocks * blocks / (3.0 * image.width * image.height);
    for (std::size_t k = 0; k < count; ++k) {
      sum[k] += block[k];
      squares[k] += block[k] * block[k];
    }
  }
  Blocks found;
  for (std::size_t k = 0; k < count; ++k) {
    found.mean.push_back(sum[k] / block_seeds);
    const double variance = std::max(0.0, squares[k] - sum[k] * sum[k] / block_seeds) / (block_seeds - 1);
    found.error.push_back(std::sqrt(variance / block_seeds));
  }
  return found;
}

/// Welch's t of every block, 16 of them with at least 7 degrees of freedom; the mean of all within `tolerance`.
inline void hold_alike(const std::string& integrator, const std::string& other, const std::string& what,
                       const Scene& scene, int samples, double tolerance) {
  INFO(what);
  const Blocks from_lights = blocks_of(scene, integrator, samples), from_camera = blocks_of(scene, other, samples);
  double ours = 0, theirs = 0, variance = 0;
  for (std::size_t k = 0; k < from_lights.mean.size(); ++k) {
    const double difference = from_lights.mean[k] - from_camera.mean[k];
    const double error = std::hypot(from_lights.error[k], from_camera.error[k]);
    INFO("block " << k << ": " << from_lights.mean[k] << " where " << other << " has " << from_camera.mean[k] << ", +- "
                  << error);
    CHECK(std::fabs(difference) <= 6 * error + 1e-6);
    variance += error * error;
    ours += from_lights.mean[k];
    theirs += from_camera.mean[k];
  }
  INFO("together " << ours << " where " << other << " has " << theirs << ", +- " << std::sqrt(variance));
  CHECK(theirs > 0);
  CHECK(ours == Approx(theirs).epsilon(tolerance));
}

inline bool is_told_alike(const RenderResult& a, const RenderResult& b) {
  return a.error && b.error && a.error->rmse == b.error->rmse && a.error->rmse_high == b.error->rmse_high;
}

/// The scene's picture and its told error have the same bits at each width, in other launches, and with 16 lanes by the
/// program with every effect.
inline void hold_same_ways(const Scene& scene, const std::vector<int>& widths) {
  const RenderResult expected = render("pocl", scene, {});
  CHECK(lit_pixels(expected.color) > 200);
  for (const int lanes : widths) {
    RenderSettings other;
    other.lanes = lanes;
    other.passes = 5;
    other.work_group = {3, 2};
    other.generic = lanes == 16;
    const RenderResult found = render("pocl", scene, other);
    CHECK(same_bits(expected, found));
    CHECK(is_told_alike(expected, found));
  }
}

/// A ball over a floor, both of the material.
inline Scene ball_on_floor(const Material& material) {
  Scene scene;
  scene.materials = {material};
  add(scene, Rectangle{{-3, -3, 0}, {6, 0, 0}, {0, 6, 0}});
  add(scene, Sphere{{0, 0, 0.8}, 0.8});
  scene.camera = perspective_camera({0, -5, 3}, {0, 0, 0.4}, {0, 0, 1}, 40);
  scene.film.filter = {FilterKind::box, 0.5, 0.5};
  scene.integrator.max_depth = 5;
  return scene;
}

inline Scene grey_ball() { return ball_on_floor(diffuse({0.7, 0.5, 0.3}, true)); }

inline Scene under_lamp(const Material& material) {
  Scene scene = ball_on_floor(material);
  add(scene, emitting(Rectangle{{-1, -1, 4}, {0, 2, 0}, {2, 0, 0}}, {4, 4, 4}));
  return scene;
}

}  // namespace strahl::test
