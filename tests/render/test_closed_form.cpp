// SPDX-License-Identifier: MIT
// Pictures whose every pixel has a closed form: irradiance by point and directional lights, emission, depth, normals,
// the edge of a hard shadow, sides, hidden emitters, depth of paths. In robust; with STRAHL_ALL_TIERS in every tier.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "render/stage.h"
#include "scene/model/build.h"

namespace strahl::test {
namespace {

/// Of a picture's floats: the device's arithmetic in single precision, the picture's own float in double.
double rounding(Precision precision) { return precision == Precision::fp64 ? 1e-7 : 1e-6; }

TEST_CASE("a point light over a plane: rho / pi I cos / d^2") {
  require_pocl();
  const Vec3 at{0.3, -0.4, 1.5};
  Scene scene = stage({floor_plane()}, diffuse({0.8, 0.5, 0.25}));
  scene.lights = {light(PointLight{at, {10, 5, 2}})};
  for (const Precision precision : asked_tiers()) {
    const Image image = color(scene, precision);
    double worst = 0;
    for (int y = 0; y < stage_size; ++y)
      for (int x = 0; x < stage_size; ++x) {
        const Vec3 to = at - Vec3{stage_x(x), stage_y(y), 0};
        const double irradiance = to.z / std::pow(length(to), 3);
        const std::array<double, 3> expected{0.8 * 10, 0.5 * 5, 0.25 * 2};
        for (int c = 0; c < 3; ++c) {
          const double radiance = expected.at(static_cast<std::size_t>(c)) / std::numbers::pi * irradiance;
          worst = std::max(worst, std::fabs(image.at(x, y, c) / radiance - 1));
        }
      }
    CHECK(worst < rounding(precision));
  }
}

TEST_CASE("a directional light: rho / pi E cos") {
  require_pocl();
  Scene scene = stage({floor_plane()}, diffuse({0.6, 0.6, 0.6}));
  scene.lights = {light(DirectionalLight{{1, 2, -2}, {3, 2, 1}})};
  for (const Precision precision : asked_tiers()) {
    const Image image = color(scene, precision);
    double worst = 0;
    for (std::size_t i = 0; i < image.data.size(); ++i) {
      const double radiance = 0.6 / std::numbers::pi * (3.0 - static_cast<double>(i % 3)) * 2 / 3;
      worst = std::max(worst, std::fabs(image.data[i] / radiance - 1));
    }
    CHECK(worst < rounding(precision));
  }
}

TEST_CASE("a lens sees a disk out of focus from a part of itself, and one in focus from everywhere") {
  require_pocl();
  constexpr double focus = 4, aperture = 0.5, radius = 0.125;
  for (const double depth : {3.0, 4.0, 7.0}) {
    Scene scene = stage({Disk{{0, 0, -depth}, {radius, 0, 0}, {0, radius, 0}}});
    scene.shapes.front().radiance = Rgb{1, 1, 1};
    scene.integrator.name = "emission";
    scene.camera = perspective_camera({0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 0.001);
    scene.camera.aperture_radius = aperture;
    scene.camera.focus_distance = focus;
    scene.film.width = scene.film.height = 1;
    scene.sampler.kind = SamplerKind::sobol;
    scene.sampler.sample_count = 4096;
    // A ray through the focus meets the disk from places on the lens up to this share of its radius.
    const double share = depth == focus ? 1 : std::min(radius / (aperture * std::fabs(1 - depth / focus)), 1.0);
    CHECK(color(scene).at(0, 0, 0) == Approx(share * share).margin(0.003));
  }
}

TEST_CASE("several lights add up") {
  require_pocl();
  Scene scene = stage({floor_plane()});
  const Light first = light(DirectionalLight{{0, 0, -1}, {1, 1, 1}}), second = light(PointLight{{0, 0, 2}, {1, 1, 1}});
  scene.lights = {first};
  const Image a = color(scene);
  scene.lights = {second};
  const Image b = color(scene);
  scene.lights = {first, second};
  const Image sum = color(scene);
  for (std::size_t i = 0; i < sum.data.size(); ++i) REQUIRE(sum.data[i] == Approx(a.data[i] + b.data[i]).epsilon(1e-6));
}

TEST_CASE("emission is the colour that was given, exactly") {
  require_pocl();
  Scene scene = stage({Rectangle{{-2, -2, 0}, {4, 0, 0}, {0, 4, 0}}});
  scene.shapes[0].radiance = Rgb{0.1, 1.7, 3.3};
  for (const char* integrator : {"emission", "direct"})
    for (const Precision precision : asked_tiers()) {
      scene.integrator.name = integrator;
      const Image image = color(scene, precision);
      for (std::size_t i = 0; i < image.data.size(); ++i) {
        const std::array<float, 3> expected{0.1F, 1.7F, 3.3F};
        REQUIRE(image.data[i] == expected.at(i % 3));
      }
    }
}

TEST_CASE("depth is the distance along the ray") {
  require_pocl();
  Scene scene = stage({floor_plane()});
  scene.integrator.name = "depth";
  scene.camera.projection = Projection::perspective;
  scene.camera.fov_degrees = 90;
  scene.camera.world_from_camera.m = {{{-1, 0, 0, 7}, {0, 1, 0, -3}, {0, 0, -1, 4}}};
  for (const Precision precision : asked_tiers()) {
    const Image image = color(scene, precision);
    double worst = 0;
    for (int y = 0; y < stage_size; ++y)
      for (int x = 0; x < stage_size; ++x) {
        const double expected = 4 * length({stage_x(x) / half_width, stage_y(y) / half_width, 1});
        worst = std::max(worst, std::fabs(image.at(x, y, 0) / expected - 1));
      }
    CHECK(worst < rounding(precision));
  }
}

TEST_CASE("normals of a sphere") {
  require_pocl();
  const double radius = 1.3;
  Scene scene = stage({Sphere{{0.2, -0.1, 0}, radius}});
  scene.integrator.name = "normals";
  for (const Precision precision : asked_tiers()) {
    const Image image = color(scene, precision);
    double worst = 0;
    for (int y = 0; y < stage_size; ++y)
      for (int x = 0; x < stage_size; ++x) {
        const double u = (stage_x(x) - 0.2) / radius, v = (stage_y(y) + 0.1) / radius, rest = 1 - u * u - v * v;
        if (std::fabs(rest) < 1e-4) continue;
        const bool hit = rest > 0;
        REQUIRE((image.at(x, y, 2) > 0) == hit);
        if (!hit) continue;
        const std::array<double, 3> normal{u, v, std::sqrt(rest)};
        for (int c = 0; c < 3; ++c)
          worst = std::max(worst, std::fabs(2 * image.at(x, y, c) - 1 - normal.at(static_cast<std::size_t>(c))));
      }
    CHECK(worst < (precision == Precision::fp64 ? 3e-7 : 1e-5));
  }
}

TEST_CASE("the shadow of a sphere ends where the tangent cone meets the plane") {
  require_pocl();
  Scene scene = stage({floor_plane(), Sphere{{0.1, 0.2, 1.5}, 0.5}});
  scene.camera.world_from_camera.m[2][3] = 0.8;  // Below the sphere.
  const auto check = [&](const Vec3& center, double radius) {
    for (const Precision precision : asked_tiers()) {
      const Image image = color(scene, precision);
      int dark = 0;
      for (int y = 0; y < stage_size; ++y)
        for (int x = 0; x < stage_size; ++x) {
          const double distance = length(Vec3{stage_x(x), stage_y(y), 0} - center);
          if (std::fabs(distance - radius) < 1e-5) continue;
          INFO(x << ", " << y << ", " << precision_name(precision));
          REQUIRE((image.at(x, y, 0) == 0) == (distance < radius));
          dark += distance < radius ? 1 : 0;
        }
      CHECK(dark > 50);
    }
  };
  const double sine = 0.5 / 3;  // Light 3 above the sphere's centre.
  scene.lights = {light(PointLight{{0.1, 0.2, 4.5}, {1, 1, 1}})};
  check({0.1, 0.2, 0}, 4.5 * sine / std::sqrt(1 - sine * sine));
  scene.lights = {light(DirectionalLight{{0, 0, -1}, {1, 1, 1}})};
  check({0.1, 0.2, 0}, 0.5);
}

TEST_CASE("a light beyond which something stands is not shadowed by it") {
  require_pocl();
  Scene scene = stage({floor_plane(), Sphere{{0, 0, 3}, 0.5}});
  scene.camera.world_from_camera.m[2][3] = 0.5;
  scene.lights = {light(PointLight{{0, 0, 2}, {1, 1, 1}})};
  CHECK(lit_pixels(color(scene)) == stage_size * stage_size);
}

TEST_CASE("diffuse is one-sided unless told otherwise") {
  require_pocl();
  const Plane away{{0, 0, 0}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}};
  const Light above = light(PointLight{{0, 0, 2}, {1, 1, 1}}), below = light(PointLight{{0, 0, -2}, {1, 1, 1}});
  const auto lit = [](const Geometry& plane, bool twosided, const Light& lamp) {
    Scene scene = stage({plane}, diffuse({0.5, 0.5, 0.5}, twosided));
    scene.lights = {lamp};
    return lit_pixels(color(scene));
  };
  const std::size_t all = stage_size * stage_size;
  CHECK(lit(floor_plane(), false, above) == all);
  CHECK(lit(floor_plane(), true, above) == all);
  CHECK(lit(away, false, above) == 0);
  CHECK(lit(away, true, above) == all);
  for (const Plane& plane : {floor_plane(), away})
    for (const bool twosided : {false, true}) CHECK(lit(plane, twosided, below) == 0);
}

TEST_CASE("max_depth counts as Mitsuba does, and hide_emitters hides what emits") {
  require_pocl();
  Scene scene = stage({floor_plane()}, diffuse({0.5, 0.5, 0.5}));
  scene.shapes[0].radiance = Rgb{2, 2, 2};
  scene.lights = {light(DirectionalLight{{0, 0, -1}, {1, 1, 1}})};
  const auto value = [&](int max_depth, bool hide) {
    scene.integrator.max_depth = max_depth;
    scene.integrator.hide_emitters = hide;
    return color(scene).data[0];
  };
  const double reflected = 0.5 / std::numbers::pi;
  CHECK(value(0, false) == 0);
  CHECK(value(1, false) == 2);
  CHECK(value(1, true) == 0);
  for (const int depth : {-1, 2, 5}) {
    CHECK(value(depth, false) == Approx(2 + reflected).epsilon(1e-6));
    CHECK(value(depth, true) == 0);
  }
  scene.integrator.name = "emission";
  CHECK(value(0, false) == 0);
  CHECK(value(1, false) == 2);
  CHECK(value(-1, false) == 2);
  scene.integrator.name = "direct";
  scene.shapes.push_back(stage({Plane{{0, 0, -3}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}}}).shapes[0]);
  scene.lights[0] = light(PointLight{{0, 0, -1}, {1, 1, 1}});
  CHECK(value(2, true) > 0);
}

/// The mean of the only pixels' red.
double mean_red(const Scene& scene) {
  RenderSettings settings;  // Of no more effects than the scene calls for.
  const Image image = render("pocl", scene, settings).color;
  double sum = 0;
  for (std::size_t i = 0; i < image.data.size(); i += 3) sum += static_cast<double>(image.data[i]);
  return sum / (static_cast<double>(image.data.size()) / 3);
}

TEST_CASE("blends and masks draw numbers with the sampler centre too") {
  require_pocl();
  Scene blend = stage({floor_plane()}, diffuse({1, 1, 1}));
  blend.materials.push_back(diffuse({0, 0, 0}));
  Material both;
  both.bsdf = Blend{{{0.3, 0.3, 0.3}}, 0, 1};
  blend.materials.push_back(both);
  blend.shapes[0].material = 2;
  Scene mask = stage({floor_plane()}, diffuse({1, 1, 1}));
  mask.materials[0].opacity = Reflectance{{0.7, 0.7, 0.7}};
  for (Scene scene : {blend, mask})
    for (const char* integrator : {"direct", "whitted", "path"}) {
      INFO(integrator);
      scene.integrator.name = integrator;
      scene.lights = {light(DirectionalLight{{0, 0, -1}, {std::numbers::pi, 1, 1}})};
      scene.sampler.sample_count = 64;
      CHECK(mean_red(scene) == Approx(0.7).margin(0.01));
    }
}

TEST_CASE("phong and ward are scaled by what their textures reflect at most") {
  require_pocl();
  const auto picture = [](const auto& bsdf, const std::vector<Texture>& textures) {
    Material material;
    material.bsdf = bsdf;
    Scene scene = stage({floor_plane()}, material);
    scene.textures = textures;
    scene.lights = {light(DirectionalLight{{0, 0.6, -0.8}, {std::numbers::pi, 1, 1}})};
    return mean_red(scene);
  };
  const auto texture = [](double value) {
    Texture made;
    Bitmap bitmap;
    bitmap.texels = std::make_shared<const Texels>(texels_of_floats(1, 1, 1, {static_cast<float>(value)}));
    made.pattern = bitmap;
    return made;
  };
  const auto check = [&](auto bsdf) {
    for (const auto& [d, s] : {std::pair{0.75, 0.75}, std::pair{0.5, 0.375}}) {
      INFO(d << " and " << s);
      bsdf.diffuse_reflectance = {{d, d, d}};
      bsdf.specular_reflectance = {{s, s, s}};
      const double wanted = picture(bsdf, {});
      bsdf.diffuse_reflectance = {{0.1, 0.1, 0.1}, 0};
      CHECK(picture(bsdf, {texture(d)}) == Approx(wanted).epsilon(1e-5));
      bsdf.specular_reflectance = {{0.1, 0.1, 0.1}, 1};
      CHECK(picture(bsdf, {texture(d), texture(s)}) == Approx(wanted).epsilon(1e-5));
    }
  };
  check(Phong{});
  check(Ward{});
}

/// Heights of 0.3 u over a square 4 wide: a plane of slope 0.075. The mesh is mirrored, or wound against its normals.
TEST_CASE("a bump map rises along vertex normals, whichever way the triangles face") {
  require_pocl();
  Mesh square;
  square.positions = {{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}};
  square.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  square.normals.assign(4, Vec3{0, 0, 1});
  Bitmap ramp;
  ramp.texels = std::make_shared<const Texels>(texels_of_floats(2, 1, 1, {0, 0.15F}));
  ramp.wrap = TextureWrap::clamp;
  Relief relief;
  relief.kind = Relief::Kind::heights;
  relief.use_shadowing_function = false;
  relief.map.texture = 0;
  relief.nested = 0;
  for (const bool faces_away : {false, true}) {
    INFO("faces away: " << faces_away);
    square.triangles = {{0, 1, 2}, {0, 2, 3}};
    if (faces_away) square.triangles = {{0, 2, 1}, {0, 3, 2}};
    Scene scene = stage({square}, diffuse({1, 1, 1}, true));
    scene.textures.push_back({"", ramp, {}, true});
    scene.shapes[0].material = add(scene, relief);
    scene.lights = {light(DirectionalLight{{0.6, 0, -0.8}, {std::numbers::pi, 1, 1}})};
    // Texels' middles lie a quarter of the width from the edges, and beyond them a clamped ramp is flat.
    const Image image = color(scene);
    const double slope = 0.075, wanted = (0.8 + 0.6 * slope) / std::sqrt(1 + slope * slope);
    CHECK(image.at(stage_size / 2, stage_size / 2, 0) == Approx(wanted).epsilon(1e-4));
    CHECK(image.at(1, stage_size / 2, 0) == Approx(0.8).epsilon(1e-4));
  }
}

}  // namespace
}  // namespace strahl::test
