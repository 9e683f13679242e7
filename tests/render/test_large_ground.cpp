// SPDX-License-Identifier: MIT
// A ground that reaches to the horizon is lit as a small one is: what stands on it casts the same shadow, in every
// tier.
#include <catch2/catch.hpp>
#include <cmath>

#include "render/pictures.h"
#include "scene/model/build.h"

namespace strahl::test {
namespace {

enum class Ground { rectangle, triangles };

/// A sphere on a square of that half side, under a point light, seen from above: the ground fills the picture. Two
/// triangles: their common edge passes below the sphere.
Scene scene_of(double half, Vec3 along, Ground ground) {
  Scene scene;
  scene.materials = {Material{}};
  scene.integrator.name = "path";
  scene.integrator.max_depth = 3;
  add(scene, Sphere{{0, 0, 1}, 1});
  const Vec3 u = half * along, v = half * Vec3{-along.y, along.x, 0};
  if (ground == Ground::rectangle)
    add(scene, Rectangle{-1.0 * (u + v), 2.0 * u, 2.0 * v});
  else
    add(scene, Mesh{{-1.0 * (u + v), u - v, u + v, v - u}, {}, {}, {{0, 1, 2}, {0, 2, 3}}, {}, {}, {}});
  add(scene, PointLight{{2, -3, 3}, {30, 30, 30}});
  scene.camera = perspective_camera({0, -6, 5}, {0, 0, 0}, {0, 0, 1}, 40);
  scene.film.width = scene.film.height = 16;
  scene.sampler.sample_count = 16;
  return scene;
}

/// The root mean square of the difference, in means of the first picture.
double difference(const Image& first, const Image& other) {
  double squares = 0, sum = 0;
  for (std::size_t i = 0; i < first.data.size(); ++i) {
    squares += std::pow(static_cast<double>(other.data[i]) - static_cast<double>(first.data[i]), 2);
    sum += static_cast<double>(first.data[i]);
  }
  return std::sqrt(squares * static_cast<double>(first.data.size())) / sum;
}

/// most: of the difference.
void hold_alike(Ground ground, const Vec3& along, Precision precision, double most) {
  RenderSettings settings;
  settings.precision = precision;
  settings.generic = precision != Precision::fast;  // Which other tests have built.
  const Image first = render("pocl", scene_of(100, along, ground), settings).color;
  for (const double half : {1e3, 1e4, 1e5, 1e6, 1e7}) {
    CAPTURE(along.x, precision_name(precision), half);
    CHECK(difference(first, render("pocl", scene_of(half, along, ground), settings).color) < most);
  }
}

TEST_CASE("a ground from 100 to 10^7 is lit alike") {
  require_pocl();
  std::vector<Precision> tiers = asked_tiers();
  tiers.push_back(Precision::fast);
  // Along the axes and turned within its plane.
  for (const Vec3 along : {Vec3{1, 0, 0}, Vec3{0.8, 0.6, 0}})
    for (const Precision precision : tiers)
      // t is rounded with the corners in `stable`: where the sphere touches the ground the wrong one may be nearer.
      hold_alike(Ground::rectangle, along, precision, precision == Precision::stable ? 0.01 : 0.002);
}

TEST_CASE("so is one of two triangles, along their common edge") {
  require_pocl();
  for (const Vec3 along : {Vec3{1, 0, 0}, Vec3{0.8, 0.6, 0}})
    for (const Precision precision : asked_tiers())
      hold_alike(Ground::triangles, along, precision, precision == Precision::stable ? 0.04 : 0.01);
}

TEST_CASE("nor does a shape that is far off and as large darken what is near") {
  require_pocl();
  for (const Precision precision : asked_tiers()) {
    const RenderSettings settings = generic_settings(precision);
    Scene scene = scene_of(100, {1, 0, 0}, Ground::rectangle);
    const Image first = render("pocl", scene, settings).color;
    add(scene, Sphere{{0, -3e22, 0}, 1e22});
    CAPTURE(precision_name(precision));
    CHECK(difference(first, render("pocl", scene, settings).color) < 1e-3);
  }
}

/// Beyond 500 from the camera a point of this ground is interpolated over corners, nearer it is found along its ray: a
/// row of the picture has the border.
Scene border_scene() {
  Scene scene;
  scene.materials = {Material{}};
  scene.integrator.name = "path";
  scene.integrator.max_depth = 2;
  add(scene, Rectangle{{-1000, 0, 1000}, {2000, 0, 0}, {0, 0, -2000}});
  scene.shapes.push_back(emitting(Rectangle{{-10, 20, 50}, {20, 0, 0}, {0, 0, 20}}, {1, 1, 1}));
  scene.camera = perspective_camera({0, 5, 0}, {0, 5, 1}, {0, 1, 0}, 40);
  scene.film.width = 512;
  scene.film.height = 512;
  scene.film.crop = Window{0, 256, 32, 384};
  scene.sampler.sample_count = 4;
  return scene;
}

TEST_CASE("how a large ground is traversed does not change a bit of a picture") {
  require_pocl();
  RenderSettings settings;
  const Image first = render("pocl", border_scene(), settings).color;
  CHECK(lit_pixels(first) > 32 * 100);
  settings.lanes = 8;
  CHECK((render("pocl", border_scene(), settings).color.data == first.data));
  if (!is_of_all_tiers()) return;
  settings.lanes = 1;
  CHECK((render("pocl", border_scene(), settings).color.data == first.data));
  CHECK((render("pocl", border_scene(), all_aovs()).color.data == first.data));
}

}  // namespace
}  // namespace strahl::test
