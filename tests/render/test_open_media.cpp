// SPDX-License-Identifier: MIT
// Media without an end: what they leave of light from infinitely far away, in closed form. As in Mitsuba 3.9.1 the way
// of a direction that is drawn for such a light ends at twice the radius of the ball around the scene, or twice the
// distance from its middle; other ways have no end, and bring no light. 10 s.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "program/features.h"
#include "render/filled.h"
#include "scene/model/build.h"
#include "scene/open_media.h"

namespace strahl::test {
namespace {

constexpr double sigma = 0.05, above = 4;  // The camera's distance from the floor.

/// A floor of 2 half_side, whose middle is the world's origin, in fog.
Scene floor_in_fog(double half_side, double albedo, const Light& lamp) {
  const double side = 2 * half_side;
  Scene scene = stage({Rectangle{{-half_side, -half_side, 0}, {side, 0, 0}, {0, side, 0}}});
  scene.media = {medium({sigma, sigma, sigma}, {albedo, albedo, albedo})};
  scene.camera.medium = 0;
  scene.shapes.front().media = MediumBoundary{-1, 0};
  scene.integrator.name = "volpath";
  scene.lights = {lamp};
  return scene;
}

Light downwards() { return light(DirectionalLight{{0, 0, -1}, {2, 2, 2}}); }
double ball_radius(double half_side) { return std::sqrt(2) * half_side; }

TEST_CASE("a floor in fog without an end is lit from afar") {
  require_pocl();
  const double reflected = 0.5 * 2 / std::acos(-1.0);
  for (const double half_side : {5.0, 2.5}) {
    const Scene scene = floor_in_fog(half_side, 0, downwards());
    const double expected = reflected * std::exp(-sigma * (above + 2 * ball_radius(half_side)));
    CHECK(static_cast<double>(color(scene, Precision::robust).at(20, 25, 0)) == Approx(expected).epsilon(1e-5));
    // A program of its own.
    CHECK(static_cast<double>(render("pocl", scene, {}).color.at(20, 25, 0)) == Approx(expected).epsilon(1e-5));
  }
}

TEST_CASE("bodies on the way take the fog's place and do not lengthen the way") {
  require_pocl();
  Scene scene = floor_in_fog(5, 0, downwards());
  scene.materials.emplace_back().opacity = Reflectance{{0, 0, 0}};
  add(scene, Cube{{-3, -3, 1}, {{{6, 0, 0}, {0, 6, 0}, {0, 0, 2}}}}, 1);
  scene.media.push_back(medium({0.3, 0.3, 0.3}, {0, 0, 0}));
  scene.shapes.back().media = MediumBoundary{1, 0};
  const double reach = std::sqrt(5 * 5 + 5 * 5 + 1.5 * 1.5);  // Of a ball around 0, 0, 1.5.
  const double depth = sigma * (above - 2 + 2 * reach - 2) + 0.3 * 4;
  CHECK(static_cast<double>(color(scene, Precision::robust).at(20, 25, 0)) ==
        Approx(std::exp(-depth) / std::acos(-1.0)).epsilon(1e-5));
}

/// What fog of albedo 1/2 scatters once towards the camera, and what it leaves of the floor's light.
double once_scattered(double half_side, double x, double y) {
  const double pi = std::acos(-1.0), irradiance = 2;
  const auto lit = [&](double z) {
    return irradiance * std::exp(-2 * sigma * std::max(ball_radius(half_side), std::sqrt(x * x + y * y + z * z)));
  };
  constexpr int steps = 400;
  double sum = 0.5 / pi * lit(0) * std::exp(-sigma * above);
  for (int i = 0; i < steps; ++i) {
    const double z = above * (i + 0.5) / steps;
    sum += 0.5 * sigma / (4 * pi) * lit(z) * std::exp(-sigma * (above - z)) * above / steps;
  }
  return sum;
}

TEST_CASE("fog without an end scatters light from afar, beyond the ball around the scene too") {
  require_pocl();
  Scene scene = floor_in_fog(2, 0.5, downwards());
  scene.film.filter.kind = FilterKind::box;  // No sample beside the floor.
  scene.integrator.max_depth = 2;
  double expected = 0;
  for (int row = 0; row < stage_size; ++row)
    for (int column = 0; column < stage_size; ++column)
      expected += once_scattered(2, stage_x(column), stage_y(row)) / (stage_size * stage_size);
  CHECK(mean_of(drawn(scene, 256)).g == Approx(expected).epsilon(2e-3));
}

// Directions of the floor find no sky, but count as if they did: w = p^2 / (p^2 + q^2), p = 1 / 4 pi, q = cos / pi.
TEST_CASE("a sky shows through fog what its own directions bring, by their weights") {
  require_pocl();
  const double expected = 0.5 * std::exp(-sigma * (above + 2 * ball_radius(5))) * std::log(17) / 16;
  const Scene even = floor_in_fog(5, 0, light(ConstantLight{{1, 1, 1}}));
  CHECK(mean_of(drawn(even, 256)).r == Approx(expected).epsilon(4e-3));
}

// With a chance c of drawing the sky q = c / 4 pi. It is 1/2, whatever the sun's power.
TEST_CASE("a sky beside a sun in fog is drawn as often") {
  require_pocl();
  Scene both = floor_in_fog(5, 0, light(ConstantLight{{1, 0, 0}}));
  add(both, DirectionalLight{{0, 0, -1}, {0, 0, 20}});
  const double expected = 0.5 * std::exp(-sigma * (above + 2 * ball_radius(5))) * std::log(65) / 64;
  CHECK(mean_of(drawn(both, 1024)).r == Approx(expected).epsilon(1e-2));
}

// A grid ends where its box does; programs with and without the effect agree.
TEST_CASE("nothing is cut where no medium is without an end") {
  require_pocl();
  Scene scene = floor_in_fog(5, 0, downwards());
  scene.integrator.name = "volpath";
  add(scene, Box{{-20, -20, -20}, {20, 20, 20}});
  scene.shapes.back().material = static_cast<int>(scene.materials.size());
  scene.materials.emplace_back().opacity = Reflectance{{0, 0, 0}};
  scene.shapes.back().media = MediumBoundary{0, -1};
  REQUIRE_FALSE(open_medium(scene));
  const double expected = 0.5 * 2 / std::acos(-1.0) * std::exp(-sigma * (above + 20));
  for (const bool generic : {false, true}) {
    RenderSettings settings;
    settings.generic = generic;
    CHECK(static_cast<double>(render("pocl", scene, settings).color.at(20, 25, 0)) == Approx(expected).epsilon(1e-5));
  }
}

TEST_CASE("which media may have no end") {
  const Scene fog = floor_in_fog(5, 0.5, downwards());
  CHECK(open_medium(fog));
  Scene path = fog, clear = fog, lake = fog;
  path.integrator.name = "path";
  CHECK_FALSE(open_medium(path));
  clear.media.front().sigma_t = Rgb{0, 0, 0};
  CHECK_FALSE(open_medium(clear));
  lake.camera.medium = -1;
  CHECK(open_medium(lake));
  lake.shapes.front().media = MediumBoundary{0, -1};
  CHECK(open_medium(lake));
  lake.shapes.front().geometry = Sphere{};
  CHECK_FALSE(open_medium(lake));
  lake.shapes.front().flip_normals = true;
  CHECK(open_medium(lake));
  // Meshes face outwards where their triangles, turned or not by flip_normals, do.
  Mesh body;
  body.positions = {{9, 9, 9}, {10, 9, 9}, {9, 10, 9}, {9, 9, 10}};
  body.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  for (const bool is_mirrored : {false, true}) {
    if (is_mirrored)
      for (Vec3& p : body.positions) p.x = -p.x;
    lake.shapes.front().geometry = body;
    for (const bool is_flipped : {false, true}) {
      lake.shapes.front().flip_normals = is_flipped;
      CHECK(open_medium(lake).has_value() == (is_mirrored != is_flipped));
    }
  }
  // One with a border has the medium on both sides of it, in whatever order its triangles are.
  body.triangles.pop_back();
  for (int turn = 0; turn < 3; ++turn) {
    std::ranges::rotate(body.triangles, body.triangles.begin() + 1);
    lake.shapes.front().geometry = body;
    lake.shapes.front().flip_normals = turn == 0;
    CHECK(open_medium(lake));
  }
  // A tube, whose borders cancel each other's area.
  Mesh tube;
  for (const double z : {9.0, 10.0})
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}) tube.positions.push_back({x, y, z});
  for (int side = 0; side < 3; ++side) {
    const int next = (side + 1) % 3;
    tube.triangles.push_back({side, next, next + 3});
    tube.triangles.push_back({side, next + 3, side + 3});
  }
  lake.shapes.front().flip_normals = false;
  lake.shapes.front().geometry = tube;
  CHECK(open_medium(lake));
  tube.triangles.push_back({0, 2, 1});
  tube.triangles.push_back({3, 4, 5});
  lake.shapes.front().geometry = tube;
  CHECK_FALSE(open_medium(lake));
  // Within a box of fog, and in one that does not reach as far.
  Scene boxed = fog;
  add(boxed, Box{{-5, -5, 0}, {5, 5, 6}});
  CHECK(open_medium(boxed));
  boxed.shapes.back().media = MediumBoundary{0, -1};
  CHECK_FALSE(open_medium(boxed));
  boxed.shapes.back().media = MediumBoundary{0, 0};
  CHECK(open_medium(boxed));
  boxed.shapes.back() = boxed.shapes.front();
  boxed.shapes.back().geometry = Box{{-4, -5, 0}, {5, 5, 6}};
  boxed.shapes.back().media = MediumBoundary{0, -1};
  CHECK(open_medium(boxed));
}

TEST_CASE("a program ends ways where a medium may have no end and a light that is drawn is infinitely far away") {
  const auto is_on = [](const Scene& scene, const RenderSettings& settings = {}) {
    return features_of(scene, settings).flag("OPEN_MEDIA");
  };
  const Scene fog = floor_in_fog(5, 0.5, light(ConstantLight{}));
  CHECK(is_on(fog));
  RenderSettings without;
  without.disabled = {"MEDIA"};
  CHECK_FALSE(is_on(fog, without));
  Scene undrawn = fog, near = fog, closed = fog;
  undrawn.lights.front().sampling_weight = 0;
  CHECK_FALSE(is_on(undrawn));
  near.lights = {light(PointLight{})};
  CHECK_FALSE(is_on(near));
  closed.camera.medium = -1;
  closed.shapes.front().media.reset();
  CHECK_FALSE(is_on(closed));
}

}  // namespace
}  // namespace strahl::test
