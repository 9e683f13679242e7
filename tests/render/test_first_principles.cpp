// SPDX-License-Identifier: MIT
// What a picture must show whatever else it does, each in the stable tier by the smallest program that can: which way
// the camera looks, which side glows, how bright a lamp is and what it cannot shine through, that a closed room is
// dark. test_closed_form and test_mirror_box hold the same in all tiers. 3 s.
#include <catch2/catch.hpp>
#include <cmath>

#include "render/stage.h"
#include "scene/model/build.h"
#include "scene/model/transforms.h"

namespace strahl::test {
namespace {

Image small(const Scene& scene) {
  RenderSettings settings;
  settings.precision = Precision::stable;
  return render("pocl", scene, settings).color;
}

TEST_CASE("the camera looks at its target, its picture upright") {
  require_pocl();
  Scene scene = stage({});
  scene.integrator.name = "emission";
  scene.camera = perspective_camera({1, 2, 3}, {1, 2, -1}, {0, 1, 0}, 90);
  // One quarter of the view each, as seen: the left ones at smaller x, the upper ones at larger y. Behind: a wall.
  const auto quarter = [&](double x, double y, const Rgb& radiance) {
    add(scene, emitting(Rectangle{{x, y, -1}, {4, 0, 0}, {0, 4, 0}}, radiance));
  };
  quarter(-3, 2, {1, 0, 0});
  quarter(1, 2, {0, 1, 0});
  quarter(-3, -2, {0, 0, 1});
  quarter(1, -2, {1, 1, 0});
  add(scene, emitting(Rectangle{{-90, -90, 4}, {0, 180, 0}, {180, 0, 0}}, {7, 7, 7}));
  const Image image = small(scene);
  const int near = stage_size / 4, far = stage_size - 1 - near;
  const auto is = [&](int x, int y, const std::array<float, 3>& expected) {
    for (int c = 0; c < 3; ++c) CHECK(image.at(x, y, c) == expected.at(static_cast<std::size_t>(c)));
  };
  is(near, near, {1, 0, 0});
  is(far, near, {0, 1, 0});
  is(near, far, {0, 0, 1});
  is(far, far, {1, 1, 0});
  is(near, far - 1, {0, 0, 1});
}

TEST_CASE("a surface glows on the side of its normal, and flipped on the other") {
  require_pocl();
  const auto lit = [](double turn, bool flipped) {
    Scene scene = stage({});
    scene.integrator.name = "emission";
    add(scene, emitting(Rectangle{{-2 * turn, -2, 0}, {4 * turn, 0, 0}, {0, 4, 0}}, {1, 1, 1}));
    scene.shapes.back().flip_normals = flipped;
    return lit_pixels(small(scene));
  };
  const std::size_t all = stage_size * stage_size;
  CHECK(lit(1, false) == all);
  CHECK(lit(1, true) == 0);
  CHECK(lit(-1, false) == 0);
  CHECK(lit(-1, true) == all);
}

TEST_CASE("a lamp over a floor: rho / pi I cos / d^2, with what stands beyond it left out") {
  require_pocl();
  const Vec3 lamp{0.3, -0.4, 1.5};
  Scene scene = stage({floor_plane(), Sphere{{0.3, -0.4, 3.5}, 0.5}}, diffuse({0.5, 0.5, 0.5}));
  scene.camera.world_from_camera.m[2][3] = 1.2;
  scene.lights = {light(PointLight{lamp, {2, 2, 2}})};
  const Image image = small(scene);
  double worst = 0;
  for (int y = 0; y < stage_size; ++y)
    for (int x = 0; x < stage_size; ++x) {
      const Vec3 to = lamp - Vec3{stage_x(x), stage_y(y), 0};
      const double expected = 0.5 / std::numbers::pi * 2 * to.z / std::pow(length(to), 3);
      worst = std::max(worst, std::fabs(static_cast<double>(image.at(x, y, 0)) / expected - 1));
    }
  CHECK(worst < 2e-6);
}

// Down to a mirror and back up past the camera: the way is 10^5 times as long as that from the sphere to the lamp.
TEST_CASE("a point on a sphere lies on the sphere, however long the ray") {
  require_pocl();
  double worst = 0;
  for (int i = 0; i < 8; ++i) {
    const double bottom = 4.0137 + 0.0031 * i;
    Scene scene = stage({Plane{{0, 0, -1000}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}}});
    scene.materials[0].bsdf = Conductor{};
    add(scene, Sphere{{0, 0, bottom + 0.01}, 0.01}, add(scene, Diffuse{{{1, 1, 1}}}));
    add(scene, PointLight{{0, 0, bottom - 0.01}, {1e-4, 1e-4, 1e-4}});
    scene.camera.world_from_camera.m[0][0] = scene.camera.world_from_camera.m[1][1] = 0x1p-20;
    scene.integrator.name = "whitted";
    const double seen = static_cast<double>(small(scene).at(stage_size / 2, stage_size / 2, 0));
    worst = std::max(worst, std::fabs(seen * std::numbers::pi - 1));
  }
  CHECK(worst < 1e-4);
}

// 10^6 radii off, where steps of t are a tenth of the radius.
TEST_CASE("a far pebble is round, and its day side casts no shadow on itself") {
  require_pocl();
  const double radius = 0x1.8p-7;
  Scene scene = stage({Sphere{{0, 0, 0}, radius}}, diffuse({1, 1, 1}));
  const double width = scene.camera.world_from_camera.m[1][1] = 0x1p-6;
  scene.camera.world_from_camera.m[0][0] = -width;
  scene.camera.world_from_camera.m[2][3] = 10000.0137;
  add(scene, DirectionalLight{{-1, 0.5, -1}, {1, 1, 1}});
  const Image lit = small(scene);
  scene.integrator.name = "normals";
  const Image normals = small(scene);
  const Vec3 to_light = normalized(Vec3{1, -0.5, 1});
  double worst = 0;
  int dark = 0, day = 0;
  for (int y = 0; y < stage_size; ++y)
    for (int x = 0; x < stage_size; ++x) {
      const double scale = width / half_width / radius, u = stage_x(x) * scale, v = stage_y(y) * scale;
      if (u * u + v * v > 0.98) continue;
      const Vec3 n{u, v, std::sqrt(1 - u * u - v * v)};
      worst = std::max(worst, std::fabs(2 * static_cast<double>(normals.at(x, y, 2)) - 1 - n.z));
      if (dot(n, to_light) < 0.01) continue;
      ++day;
      dark += lit.at(x, y, 0) == 0 ? 1 : 0;
    }
  CHECK(worst < 1e-4);
  CHECK(dark == 0);
  CHECK(day > 200);
}

// z = (x + 2 y) / 4 over a lattice, so exactly flat; points on it are rounded to either side of it.
TEST_CASE("a flat mesh casts no shadow on itself") {
  require_pocl();
  Mesh mesh;
  constexpr int cells = 24;
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i) {
      const double x = (i - cells / 2) * 0.1875, y = (j - cells / 2) * 0.1875;
      mesh.positions.push_back({x, y, (x + 2 * y) / 4});
    }
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      const int at = j * (cells + 1) + i;
      mesh.triangles.push_back({at, at + 1, at + cells + 2});
      mesh.triangles.push_back({at, at + cells + 2, at + cells + 1});
    }
  const Vec3 normal = normalized(Vec3{-1, -2, 4});
  for (const Vec3& along : {Vec3{4, 0, 1}, Vec3{0, 2, 1}, Vec3{-4, 2, 0}, Vec3{1, -3, -1.25}})
    for (const double slope : {1e-2, 1e-4}) {
      Scene scene = stage({mesh}, diffuse({1, 1, 1}));
      add(scene, DirectionalLight{normalized(along) - slope * normal, {1e4, 1e4, 1e4}});
      INFO(along.x << " " << along.y << ", slope " << slope);
      CHECK(lit_pixels(small(scene)) == stage_size * stage_size);
    }
}

/// Pixels that see a way out of a closed room of mirrors. From its middle, rays through the picture's diagonals run
/// along its edges into corners.
std::size_t escaped(const std::vector<Geometry>& room, const Vec3& eye, const Vec3& ahead) {
  Scene scene = stage({});
  const int mirror = add(scene, Conductor{}, true);
  for (const Geometry& wall : room) add(scene, wall, mirror);
  add(scene, ConstantLight{});
  scene.camera = perspective_camera(eye, eye + ahead, {0, 1, 0}, 90);
  scene.integrator.name = "whitted";
  scene.integrator.max_depth = 301;
  return lit_pixels(small(scene));
}

const Vec3 far_off{1e6, -1e6, 5e5};

TEST_CASE("no way leads out of a room of mirrors") {
  require_pocl();
  const auto room = [](bool triangles, const Transform& turn, double size, const Vec3& center) {
    std::vector<Geometry> walls;
    const auto axis = [&](int i) { return size * turn.vector({i == 0 ? 1. : 0., i == 1 ? 1. : 0., i == 2 ? 1. : 0.}); };
    for (int i = 0; i < 3; ++i)
      for (const double side : {-1., 1.}) {
        const Vec3 u = axis((i + 1) % 3), v = axis((i + 2) % 3);
        const Vec3 corner = center + side * axis(i) - u - v;
        if (triangles) {
          walls.emplace_back(Triangle{corner, corner + 2 * u, corner + 2 * u + 2 * v});
          walls.emplace_back(Triangle{corner, corner + 2 * u + 2 * v, corner + 2 * v});
        } else {
          walls.emplace_back(Rectangle{corner, 2 * u, 2 * v});
        }
      }
    return walls;
  };
  const Transform turn = rotation({1, 2, 0.5}, 37);
  for (const bool triangles : {false, true}) {
    INFO((triangles ? "triangles" : "rectangles"));
    CHECK(escaped(room(triangles, {}, 1, {}), {}, {0, 0, -1}) == 0);
    CHECK(escaped(room(triangles, turn, 1, {}), {0.1, 0.2, -0.3}, {0.3, -0.2, -1}) == 0);
    CHECK(escaped(room(triangles, turn, 3, far_off), far_off + Vec3{0.3, 0.1, 0.2}, {0.3, -0.2, -1}) == 0);
  }
}

TEST_CASE("no way leads out of a box of mirrors") {
  require_pocl();
  CHECK(escaped({Box{{-1, -1, -1}, {1, 1, 1}}}, {}, {0, 0, -1}) == 0);
  const Box off{far_off - Vec3{3, 3, 3}, far_off + Vec3{3, 3, 3}};
  CHECK(escaped({off}, far_off + Vec3{0.3, 0.1, 0.2}, {0.3, -0.2, -1}) == 0);
}

}  // namespace
}  // namespace strahl::test
