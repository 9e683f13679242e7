// SPDX-License-Identifier: MIT
// No shadow acne: on a single convex shape, every pixel that faces the light is lit and no other, near the origin and
// far from it, large and small. Rays leave their primitive by identity, so nothing depends on an epsilon.
#include <catch2/catch.hpp>
#include <cmath>

#include "render/stage.h"

namespace strahl::test {
namespace {

struct Named {
  const char* name;
  Geometry geometry;
};

/// Around `c`, about `s` in size, tilted so that nothing is aligned with the rays.
std::vector<Named> convex_shapes(const Vec3& c, double s) {
  const Vec3 a = (0.8 * s) * normalized({1, 0.3, 0.2});
  const Vec3 b = (0.7 * s) * normalized(cross({0.1, -0.2, 1}, a));
  const Vec3 n = normalized(cross(a, b));
  return {
      {"sphere", Sphere{c, s, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}},
      {"plane", Plane{c, n, a, b}},
      {"box", Box{c - Vec3{0.9 * s, 0.7 * s, 0.8 * s}, c + Vec3{0.9 * s, 0.7 * s, 0.8 * s}}},
      {"cylinder", Cylinder{c - a, c + 0.9 * a, 0.6 * s, normalized(b)}},
      {"disk", Disk{c, a, (length(a) / length(b)) * b}},
      {"rectangle", Rectangle{c - a - b, 2 * a, 2 * b}},
      {"triangle", Triangle{c - a - b, c + a, c + b}},
      {"cube", Cube{c - 0.5 * (a + b + s * n), {{a, b, s * n}}}},
  };
}

/// Pixels that show the shape's front and face the light, or turn from it; and those of them with the wrong colour.
struct LitPoints {
  int facing = 0, averted = 0, wrong = 0;
};

LitPoints count(const Geometry& geometry, const Vec3& c, double s, const Vec3& towards, bool point,
                Precision precision) {
  Scene scene = stage({geometry}, diffuse({1, 1, 1}, true));
  const Vec3 at = c + (2 * s) * towards;
  scene.lights = {point ? light(PointLight{at, {1e3 * s * s, 1e3 * s * s, 1e3 * s * s}})
                        : light(DirectionalLight{-towards, {1e3, 1e3, 1e3}})};
  const double wide = 1.3 * s;
  scene.camera.world_from_camera.m = {{{-wide, 0, 0, c.x}, {0, wide, 0, c.y}, {0, 0, -1, c.z + 10 * s}}};
  const RenderResult result = stage_picture(scene, precision);
  const int shape = channel_of(result.aov, "shape_id.I"), normal_at = channel_of(result.aov, "normal.X"),
            position_at = channel_of(result.aov, "position.X");
  LitPoints counted;
  for (int y = 0; y < stage_size; ++y)
    for (int x = 0; x < stage_size; ++x) {
      const auto value = [&](int channel) { return double{result.aov.at(x, y, channel)}; };
      if (value(shape) < 0) continue;
      const auto vector = [&](int first) { return Vec3{value(first), value(first + 1), value(first + 2)}; };
      const Vec3 normal = vector(normal_at), position = vector(position_at);
      const bool sheet = !std::holds_alternative<Sphere>(geometry) && !std::holds_alternative<Box>(geometry) &&
                         !std::holds_alternative<Cube>(geometry) && !std::holds_alternative<Cylinder>(geometry);
      if (normal.z < 0 && !sheet) continue;  // The inside of the cylinder, which its outside shadows.
      const Vec3 to = point ? normalized(at - position) : towards;
      const double cosine = dot(normal, to) * (normal.z < 0 ? -1 : 1);
      if (std::fabs(cosine) < 1e-3) continue;  // Positions and normals here are rounded to float.
      ++(cosine > 0 ? counted.facing : counted.averted);
      if ((result.color.at(x, y, 0) > 0) != (cosine > 0)) ++counted.wrong;
    }
  return counted;
}

TEST_CASE("what faces the light is lit") {
  require_pocl();
  struct Place {
    Vec3 center;
    double size;
  };
  const std::vector<Vec3> directions = {normalized({1, 2, 3}), normalized({-3, 1, 0.2}), normalized({0.5, -4, -0.3})};
  for (const Place& place : {Place{{0, 0, 0}, 1}, Place{{1234.5, -321.7, 777.1}, 1}, Place{{0.1, 0.2, 0.3}, 1e-3},
                             Place{{-10, 20, 30}, 1e4}})
    for (const Named& shape : convex_shapes(place.center, place.size))
      for (const Precision precision : asked_tiers()) {
        LitPoints all;
        for (const Vec3& direction : directions)
          for (const bool point : {false, true}) {
            const LitPoints one = count(shape.geometry, place.center, place.size, direction, point, precision);
            all.facing += one.facing;
            all.averted += one.averted;
            all.wrong += one.wrong;
          }
        INFO(shape.name << " of size " << place.size << ", " << precision_name(precision));
        CHECK(all.facing > 500);
        CHECK(all.wrong == 0);
      }
}

}  // namespace
}  // namespace strahl::test
