// SPDX-License-Identifier: MIT
// Ambient occlusion against closed forms: a floor under a disk that ends the open, near and beyond the reach. 1 s.
#include <catch2/catch.hpp>
#include <cmath>

#include "render/stage.h"
#include "scene/model/build.h"

namespace strahl::test {
namespace {

constexpr double height = 1, radius = 1.5;

/// Seen from below the disk, looking at the floor through the plane of the disk's middle.
Scene roofed(double max_distance) {
  Scene scene = stage({floor_plane(), Disk{{0, 0, height}, {radius, 0, 0}, {0, radius, 0}}});
  scene.camera = perspective_camera({0, 0, 0.9 * height}, {0, 0, 0}, {0, 1, 0}, 90);
  scene.integrator.name = "ao";
  scene.integrator.max_distance = max_distance;
  scene.sampler.sample_count = 256;
  return scene;
}

TEST_CASE("a floor under a disk sees what the disk leaves of the sky") {
  require_pocl();
  for (const Precision precision : asked_tiers()) {
    const Image image = color(roofed(std::numeric_limits<double>::infinity()), precision);
    double sum = 0, truth = 0, worst = 0;
    for (int y = 0; y < stage_size; ++y)
      for (int x = 0; x < stage_size; ++x) {
        const auto place = [](int i) { return 0.9 * height * (2 * i + 1 - stage_size) / stage_size; };
        const double a = std::hypot(place(x), place(y)), h = height / a, r = radius / a, z = 1 + h * h + r * r;
        const double open = 1 - 0.5 * (1 - (z - 2 * r * r) / std::sqrt(z * z - 4 * r * r));
        const double seen = static_cast<double>(image.at(x, y, 0));
        sum += seen;
        truth += open;
        worst = std::max(worst, std::fabs(seen - open));
      }
    CHECK(sum / truth == Approx(1).epsilon(0.003));
    CHECK(worst < 0.06);
  }
}

TEST_CASE("what is beyond the reach does not count") {
  require_pocl();
  for (const float value : color(roofed(0.99 * height)).data) CHECK(value == 1);
  // Straight up the disk is within reach, towards its rim it is not.
  const Image image = color(roofed(1.2 * height));
  const double cosine = height / (1.2 * height);
  CHECK(static_cast<double>(image.at(stage_size / 2, stage_size / 2, 0)) == Approx(cosine * cosine).margin(0.06));
}

TEST_CASE("nothing is open where nothing is hit, and both sides of a surface are sides") {
  require_pocl();
  Scene scene = stage({Rectangle{{-1, -1, 0}, {0, 2, 0}, {2, 0, 0}}});
  scene.integrator.name = "ao";
  const Image image = color(scene);
  CHECK(lit_pixels(image) == stage_size * stage_size / 4);
  for (std::size_t i = 0; i < image.data.size(); ++i) CHECK((image.data[i] == 0 || image.data[i] == 1));
}

TEST_CASE("materials and lamps do not matter, whatever else the program holds") {
  require_pocl();
  Material half = diffuse({0.5, 0.5, 0.5});
  half.opacity = Reflectance{{0.5, 0.5, 0.5}};
  Scene scene = stage({floor_plane(), Disk{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}}, half);
  scene.shapes.back().radiance = Rgb{1, 1, 1};
  scene.integrator.name = "ao";
  scene.integrator.hide_emitters = scene.integrator.strict_normals = true;
  scene.sampler.sample_count = 4;
  const Image alone = render("pocl", scene, {}).color;
  CHECK(lit_pixels(alone) > 100);
  // By the program for everything, and the albedo beside it.
  CHECK(same_bits(alone, color(scene, Precision::robust)));
}

}  // namespace
}  // namespace strahl::test
