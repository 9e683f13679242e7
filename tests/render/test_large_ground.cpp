// SPDX-License-Identifier: MIT
// A ground that reaches to the horizon is lit as a small one is: what stands on it casts the same shadow, in every
// tier.
#include <catch2/catch.hpp>
#include <cmath>

#include "render/pictures.h"
#include "scene/model/build.h"

namespace strahl::test {
namespace {

/// A sphere on a square of that half side, under a point light, seen from above: the ground fills the picture.
Scene scene_of(double half, Vec3 along) {
  Scene scene;
  scene.materials = {Material{}};
  scene.integrator.name = "path";
  scene.integrator.max_depth = 3;
  add(scene, Sphere{{0, 0, 1}, 1});
  const Vec3 u = half * along, v = half * Vec3{-along.y, along.x, 0};
  add(scene, Rectangle{-1.0 * (u + v), 2.0 * u, 2.0 * v});
  add(scene, PointLight{{2, -3, 3}, {30, 30, 30}});
  scene.camera = perspective_camera({0, -6, 5}, {0, 0, 0}, {0, 0, 1}, 40);
  scene.film.width = scene.film.height = 16;
  scene.sampler.sample_count = 16;
  return scene;
}

TEST_CASE("a ground from 100 to 10^7 is lit alike") {
  require_pocl_and_rusticl();
  // Along the axes and turned within its plane.
  for (const Vec3 along : {Vec3{1, 0, 0}, Vec3{0.8, 0.6, 0}})
    for (const Precision precision : {Precision::fast, Precision::stable, Precision::robust, Precision::fp64}) {
      RenderSettings settings;
      settings.precision = precision;
      const Image first = render("pocl", scene_of(100, along), settings).color;
      for (const double half : {1e3, 1e4, 1e5, 1e6, 1e7}) {
        CAPTURE(along.x, precision_name(precision), half);
        const Image other = render("pocl", scene_of(half, along), settings).color;
        double squares = 0, sum = 0;
        for (std::size_t i = 0; i < first.data.size(); ++i) {
          squares += std::pow(static_cast<double>(other.data[i]) - static_cast<double>(first.data[i]), 2);
          sum += static_cast<double>(first.data[i]);
        }
        const auto count = static_cast<double>(first.data.size());
        // t is rounded with the corners in `stable`: where the sphere touches the ground the wrong one may be nearer.
        const double most = precision == Precision::stable ? 0.01 : 0.002;
        CHECK(std::sqrt(squares / count) < most * sum / count);
      }
    }
}

}  // namespace
}  // namespace strahl::test
