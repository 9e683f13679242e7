// SPDX-License-Identifier: MIT
// Media that vary: against media that are alike everywhere, in closed form, in furnaces; the same bits however paths
// are followed. 20 s.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "render/filled.h"
#include "scene/model/build.h"
#include "scene/model/transforms.h"

namespace strahl::test {
namespace {

std::shared_ptr<const VolumeGrid> grid(int width, int height, int depth, int channels, std::vector<float> values) {
  return std::make_shared<const VolumeGrid>(grid_of_floats(width, height, depth, channels, std::move(values)));
}

std::shared_ptr<const VolumeGrid> random_grid(int channels) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> value(0, 1);
  std::vector<float> values(static_cast<std::size_t>(20 * 11 * 9 * channels));
  for (float& v : values) v = value(random);
  return grid(20, 11, 9, channels, std::move(values));
}

/// The grid over the cube from -1 to 1.
Medium varying(std::shared_ptr<const VolumeGrid> grid, const Rgb& scale, const Rgb& albedo) {
  Medium varying = medium(scale, albedo);
  varying.sigma_t.grid = std::move(grid);
  varying.sigma_t.world_from_cube = {{{{2, 0, 0, -1}, {0, 2, 0, -1}, {0, 0, 2, -1}}}};
  return varying;
}

Cube cube() { return {{-1, -1, -1}, {{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}}}; }

/// Rays along -z through the cube, 8 x 8 of them.
Scene seen_along_z(const Medium& medium, double around) {
  Scene scene = filled(cube(), medium, around);
  scene.film.width = scene.film.height = 8;
  scene.camera = perspective_camera({0, 0, 40}, {0, 0, 0}, {0, 1, 0}, 0.5);
  return scene;
}

TEST_CASE("a grid of one colour is the medium that is alike everywhere") {
  require_pocl();
  // Its channels have events of their own; a hero that depended on their numbers would be seen here.
  const Rgb colour{6, 3, 1.5}, albedo{0.9, 0.9, 0.9};
  Scene even = filled(Sphere{{0, 0, 0}, 1}, medium(colour, albedo), 0.5), gridded = even;
  std::vector<float> values;
  for (int i = 0; i < 8; ++i) values.insert(values.end(), {1, 0.5F, 0.25F});
  gridded.media = {varying(grid(2, 2, 2, 3, values), {6, 6, 6}, albedo)};
  for (Scene* scene : {&even, &gridded}) {
    add(*scene, PointLight{{3, 4, 3}, {40, 40, 40}});
    scene->film.width = scene->film.height = 16;
  }
  const Rgb expected = mean_of(drawn(even, 1024)), found = mean_of(drawn(gridded, 1024));
  CHECK(found.r == Approx(expected.r).epsilon(0.005));
  CHECK(found.g == Approx(expected.g).epsilon(0.005));
  CHECK(found.b == Approx(expected.b).epsilon(0.005));
}

TEST_CASE("what a ramp absorbs is its integral along the ray") {
  require_pocl();
  // Texels 0 and 1 along z: from their centres outwards it stays, between them it rises: on the mean 1/2.
  const Medium ramp = varying(grid(1, 1, 2, 1, {0, 1}), {3, 3, 3}, {0, 0, 0});
  CHECK(mean_of(drawn(seen_along_z(ramp, 1), 4096)).g == Approx(std::exp(-0.5 * 2 * 3)).epsilon(0.01));
}

TEST_CASE("a grid that only scatters is not seen in white surroundings") {
  require_pocl();
  for (const int channels : {1, 3}) {
    Medium white = varying(random_grid(channels), {5, 5, 5}, {1, 1, 1});
    for (const TextureWrap wrap : {TextureWrap::clamp, TextureWrap::mirror}) {
      white.sigma_t.wrap = wrap;
      check_unseen(white);
    }
  }
}

TEST_CASE("an empty grid around a scene leaves its every bit") {
  require_pocl();
  Scene bare = stage({Sphere{{0, 0, 0}, 0.8}}, diffuse({0.5, 0.4, 0.3}));
  bare.integrator.name = "path";
  bare.lights = {light(ConstantLight{{1, 1, 1}})};
  Scene within = filled(cube(), varying(grid(2, 2, 2, 1, std::vector<float>(8, 0.0F)), {5, 5, 5}, {1, 1, 1}));
  add(within, std::get<Sphere>(bare.shapes.front().geometry), add(within, Diffuse{{{0.5, 0.4, 0.3}}}));
  for (Scene* scene : {&bare, &within}) scene->sampler.sample_count = 4;
  CHECK(same_bits(render("pocl", bare, generic_settings()), render("pocl", within, generic_settings())));
  // What is asked beside the picture is that of the grid's boundary.
  const auto depth = [](const Scene& scene) {
    const Image aov = stage_picture(scene, Precision::robust).aov;
    return aov.at(24, 24, channel_of(aov, "depth.Z"));
  };
  CHECK(depth(within) < depth(bare) - 0.1F);
}

TEST_CASE("a grid glows as 1 - e^-depth of what it emits") {
  require_pocl();
  Medium glowing = varying(grid(1, 1, 2, 1, {0, 1}), {1.5, 1.5, 1.5}, {0, 0, 0});
  glowing.emission = Rgb{2, 3, 4};
  const Rgb mean = mean_of(drawn(seen_along_z(glowing, 0), 4096));
  CHECK(mean.r == Approx(-2 * std::expm1(-1.5)).epsilon(0.01));
  CHECK(mean.b == Approx(-4 * std::expm1(-1.5)).epsilon(0.01));
}

TEST_CASE("a grid lies where its transform puts it") {
  require_pocl();
  // Dense for x < 0 in its own frame; a quarter turn about z brings that to y < 0.
  Medium half = varying(grid(16, 1, 1, 1, {9, 9, 9, 9, 9, 9, 9, 9, 0, 0, 0, 0, 0, 0, 0, 0}), {2, 2, 2}, {0, 0, 0});
  half.sigma_t.world_from_cube = {{{{0, -2, 0, 1}, {2, 0, 0, -1}, {0, 0, 2, -1}}}};
  Scene scene = seen_along_z(half, 1);
  scene.camera = perspective_camera({0, 0, 40}, {0, 0, 0}, {0, 1, 0}, 2);
  const Image image = drawn(scene, 64);
  CHECK(static_cast<double>(image.at(4, 1, 1)) == Approx(1).margin(1e-6));
  CHECK(static_cast<double>(image.at(4, 6, 1)) < 1e-6);
}

TEST_CASE("what is emitted is that of the nearest texel, repeated") {
  require_pocl();
  // Texels 0 and 1 over z from -1 to 0, and again over 0 to 1: of four layers of depth s the second and the last glow.
  Medium layers = varying(grid(1, 1, 1, 1, {1}), {2, 2, 2}, {0, 0, 0});
  layers.emission = Rgb{5, 5, 5};
  layers.emission.grid = grid(1, 1, 2, 1, {0, 1});
  layers.emission.world_from_cube = {{{{2, 0, 0, -1}, {0, 2, 0, -1}, {0, 0, 1, -1}}}};
  layers.emission.filter = TextureFilter::nearest;
  layers.emission.wrap = TextureWrap::repeat;
  const double s = 2 * 0.5, glow = 5 * -std::expm1(-s);
  CHECK(mean_of(drawn(seen_along_z(layers, 0), 4096)).g == Approx(glow * (1 + std::exp(-2 * s))).epsilon(0.01));
}

TEST_CASE("an albedo of a grid is that of a number") {
  require_pocl();
  Medium gridded = varying(random_grid(1), {5, 5, 5}, {1, 1, 1}), even = gridded;
  even.albedo = Rgb{0.5, 0.5, 0.5};
  gridded.albedo.grid = grid(2, 2, 2, 3, std::vector<float>(24, 0.5F));
  const double expected = mean_of(drawn(filled(Sphere{{0, 0, 0}, 1}, even), 64)).g;
  CHECK(mean_of(drawn(filled(Sphere{{0, 0, 0}, 1}, gridded), 64)).g == Approx(expected).epsilon(1e-5));
}

TEST_CASE("a scene that is turned as a whole looks the same") {
  require_pocl();
  // The box along the axes around the turned cube is larger; there the grid goes on by repetition.
  Medium medium = varying(random_grid(3), {5, 4, 3}, {0.9, 0.8, 0.7});
  medium.sigma_t.wrap = TextureWrap::repeat;
  const Transform turn = rotation({1, 2, 3}, 30);
  for (const Precision precision : asked_tiers()) {
    std::vector<Rgb> means;
    for (const bool is_turned : {false, true}) {
      Medium placed = medium;
      const Transform by = is_turned ? turn : Transform{};
      placed.sigma_t.world_from_cube = by * medium.sigma_t.world_from_cube;
      Scene scene = filled(Sphere{{0, 0, 0}, 0.99}, placed, 1);
      scene.film.width = scene.film.height = 16;
      scene.camera = perspective_camera(by.point({0.5, 0, 4}), {0, 0, 0}, by.vector({0, 1, 0}), 25);
      scene.sampler.kind = SamplerKind::independent;
      scene.sampler.sample_count = 256;
      means.push_back(mean_of(color(scene, precision)));
    }
    CHECK(means[1].r == Approx(means[0].r).epsilon(0.004));
    CHECK(means[1].b == Approx(means[0].b).epsilon(0.004));
  }
}

TEST_CASE("a medium that no path would get out of is refused") {
  require_pocl();
  CHECK_THROWS_WITH(drawn(filled(Sphere{{0, 0, 0}, 1}, varying(random_grid(1), {1e20, 1e20, 1e20}, {1, 1, 1})), 1),
                    Catch::Contains("lower scale"));
}

TEST_CASE("paths through grids are the same one by one and in lanes") {
  Scene scene = filled(Sphere{{0, 0, 0}, 1}, varying(random_grid(3), {5, 4, 3}, {0.9, 0.6, 0.8}));
  add(scene, floor_plane(), add(scene, Diffuse{{{0.5, 0.4, 0.3}}}));
  check_in_lanes(scene);
}

TEST_CASE("rays along an axis of the grid end at its box, too") {
  require_pocl();
  const Medium smoke = varying(grid(1, 1, 1, 1, {1}), {1, 1, 1}, {0, 0, 0});
  Scene scene = filled(Sphere{{0, 0, 0}, 3}, smoke);
  scene.film.width = scene.film.height = 16;  // The box is over the middle 8 x 8 of them.
  scene.film.filter = {FilterKind::box, 0.5, 0.5};
  const Image image = drawn(scene, 1024);
  CHECK(mean_of(image).r == Approx(1 - (1 - std::exp(-2)) / 4).epsilon(0.003));
  CHECK(image.at(2, 8, 0) == 1);
  CHECK(image.at(8, 2, 0) == 1);
}

}  // namespace
}  // namespace strahl::test
