// SPDX-License-Identifier: MIT
// Surfaces that lie on one another: a ray that goes on behind both comes to an end.
#include <catch2/catch.hpp>

#include "render/filled.h"
#include "scene/model/build.h"

namespace strahl::test {
namespace {

Image seen(Scene scene, const char* integrator, Precision precision, int samples) {
  scene.integrator.name = integrator;
  scene.sampler.kind = SamplerKind::independent;
  scene.sampler.sample_count = samples;
  return color(scene, precision);
}

/// Level, tilted, round: the last two lie on one another to a rounding only.
const Geometry twins[] = {Disk{{0, 0, 1}, {3, 0, 0}, {0, 3, 0}}, Disk{{0.1, 0.2, 1}, {2.4, 0, 1.8}, {0, 3, 0}},
                          Sphere{{0.31, 0.17, 0.11}, 1.3}};

TEST_CASE("lamps twice in one place are hidden from the camera") {
  require_pocl();
  for (const Geometry& twin : twins) {
    Scene scene = stage({Rectangle{{-9, -9, -3}, {18, 0, 0}, {0, 18, 0}}}, diffuse({0.5, 0.5, 0.5}));
    scene.integrator.hide_emitters = true;
    scene.film.width = scene.film.height = 16;
    add(scene, PointLight{{0, 0, -2}, {4, 4, 4}});  // Below the lamps.
    for (int i = 0; i < 2; ++i) {
      add(scene, twin);
      scene.shapes.back().radiance = Rgb{0, 0, 1};
    }
    for (const Precision precision : asked_tiers()) {
      const Image image = seen(scene, "path", precision, 16);
      CHECK(lit_pixels(image) == 256);
      CHECK(image.at(8, 8, 0) > 0);
    }
  }
}

TEST_CASE("masks twice in one place let light through, once or twice") {
  require_pocl();
  for (const Geometry& twin : twins)
    for (const char* integrator : {"path", "volpath"}) {
      Material half = diffuse({0, 0, 0});
      half.opacity = Reflectance{{0.5, 0.5, 0.5}};
      Scene scene = stage({twin, twin}, half);
      scene.lights = {light(ConstantLight{{1, 1, 1}})};
      scene.film.width = scene.film.height = 8;
      const Image image = seen(scene, integrator, Precision::robust, 1024);
      const bool is_ball = std::holds_alternative<Sphere>(twin);
      INFO(integrator << ", " << twin.index());
      const double middle = static_cast<double>(image.at(4, 4, 0)), once = is_ball ? 0.25 : 0.5;
      CHECK(middle > once * once - 0.05);
      CHECK(middle < once + 0.05);
    }
}

}  // namespace
}  // namespace strahl::test
