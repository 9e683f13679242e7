// SPDX-License-Identifier: MIT
// Paths of many surfaces against what is known of them: closed rooms whose walls glow, white things under an even sky,
// mirrors; what max_depth, rr_depth and hide_emitters leave out; lights drawn against lights taken. 6 s.
#include <catch2/catch.hpp>
#include <cmath>

#include "render/stage.h"
#include "scene/model/build.h"

namespace strahl::test {
namespace {

const Cube room{{-2, -2, -2}, {{{4, 0, 0}, {0, 4, 0}, {0, 0, 8}}}};

/// The camera's stage within a shape that is turned inside out and glows.
Scene furnace(const Geometry& walls, double reflectance, int max_depth, int rr_depth = 5) {
  Scene scene = stage({}, diffuse({reflectance, reflectance, reflectance}));
  Shape shape = emitting(walls, {1, 1, 1});
  shape.flip_normals = true;
  add(scene, shape);
  scene.integrator.name = "path";
  scene.integrator.max_depth = max_depth;
  scene.integrator.rr_depth = rr_depth;
  scene.sampler.sample_count = 16;
  return scene;
}

RenderResult path_picture(const Scene& scene) {
  static const Device device = Device::open("pocl");
  return Renderer(device, scene, generic_settings()).render();
}

struct Mean {
  double value = 0, error = 0;
};

Mean mean(const Image& image) {
  double sum = 0, squares = 0, count = 0;
  for (std::size_t i = 0; i < image.data.size(); i += 3) {
    const double x = static_cast<double>(image.data[i]);
    sum += x;
    squares += x * x;
    ++count;
  }
  return {sum / count, std::sqrt(std::max(squares / count - sum * sum / (count * count), 0.0) / count)};
}

void hold_mean(const Image& image, double expected) {
  const Mean m = mean(image);
  INFO(m.value << " +- " << m.error << " where " << expected << " should be");
  CHECK(std::fabs(m.value - expected) < 4 * m.error + 1e-6 * expected);
  CHECK(m.error < 0.01 * expected);
}

TEST_CASE("in a closed room that glows there is 1 / (1 - reflectance) times the light") {
  require_pocl();
  const double rho = 0.8;
  for (const Geometry& walls : {Geometry(room), Geometry(Sphere{{0, 0, 1}, 6})}) {
    for (const int rr_depth : {5, 1}) hold_mean(path_picture(furnace(walls, rho, -1, rr_depth)).color, 1 / (1 - rho));
    hold_mean(path_picture(furnace(walls, rho, 64, 1000)).color, 1 / (1 - rho));
  }
}

TEST_CASE("max_depth n is the light of n surfaces") {
  require_pocl();
  const double rho = 0.7;
  for (const int depth : {0, 1, 2, 3, 6}) {
    INFO(depth);
    const Image image = path_picture(furnace(room, rho, depth)).color;
    if (depth < 2)
      CHECK(mean(image).value == depth);
    else
      hold_mean(image, (1 - std::pow(rho, depth)) / (1 - rho));
  }
}

TEST_CASE("mirrors count as surfaces, and show what glows") {
  require_pocl();
  Scene scene = furnace(room, 0.5, 4);
  scene.materials[0].bsdf = Conductor{{{0.5, 0.5, 0.5}}};
  const Image image = path_picture(scene).color;
  for (const float value : image.data) CHECK(value == 1.875F);
}

TEST_CASE("a mask lets pass what does not meet it, and counts as a surface") {
  require_pocl();
  Scene scene = furnace(Sphere{{0, 0, 1}, 6}, 0, 2);
  Material veil;
  veil.bsdf = Diffuse{{{0, 0, 0}}};
  veil.opacity = Reflectance{{0.25, 0.25, 0.25}};
  scene.materials.push_back(veil);
  add(scene, Sphere{{0, 0, 1}, 5}, static_cast<int>(scene.materials.size()) - 1);
  scene.sampler.sample_count = 64;
  hold_mean(path_picture(scene).color, 0.75);
  scene.integrator.max_depth = 1;
  CHECK(mean(path_picture(scene).color).value == 0);
  scene.materials.back().opacity = Reflectance{{1, 1, 1}};
  scene.integrator.max_depth = 8;
  CHECK(mean(path_picture(scene).color).value == 0);
}

TEST_CASE("a blend reflects what its materials do in proportion to its weight, under lamps and sky") {
  require_pocl();
  const auto mean_of = [](const Material& material, std::vector<Material> blended) {
    Scene scene = stage({Sphere{{0, 0, 0}, 1.5}}, diffuse({0, 0, 0}));
    for (Material& each : blended) scene.materials.push_back(each);
    scene.materials.push_back(material);
    scene.shapes[0].material = static_cast<int>(scene.materials.size()) - 1;
    add(scene, ConstantLight{{0.5, 0.5, 0.5}});
    add(scene, PointLight{{0, 1, 4}, {8, 8, 8}});
    scene.integrator.name = "path";
    scene.sampler.kind = SamplerKind::sobol;
    scene.sampler.sample_count = 256;
    return mean(path_picture(scene).color).value;
  };
  Material metal, blend;
  metal.bsdf = RoughConductor{};
  blend.bsdf = Blend{{{0.25, 0.25, 0.25}}, 1, 2};
  const Material dark = diffuse({0.2, 0.2, 0.2});
  const double expected = 0.75 * mean_of(dark, {}) + 0.25 * mean_of(metal, {});
  CHECK(mean_of(blend, {dark, metal}) == Approx(expected).epsilon(3e-3));
}

TEST_CASE("a twosided material may be another from behind") {
  require_pocl();
  const auto red_over_green = [](bool is_flipped) {
    Scene scene = stage({floor_plane()}, diffuse({0.5, 0, 0}));
    add(scene, ConstantLight{{1, 1, 1}});
    scene.materials.push_back(scene.materials[0]);
    scene.materials[1].bsdf = Diffuse{{{0, 0.5, 0}}};
    scene.materials[0].twosided = true;
    scene.materials[0].back = 1;
    scene.shapes[0].flip_normals = is_flipped;
    scene.integrator.name = "path";
    const Image image = path_picture(scene).color;
    double difference = 0;
    for (std::size_t i = 0; i < image.data.size(); i += 3)
      difference += static_cast<double>(image.data[i]) - static_cast<double>(image.data[i + 1]);
    return difference;
  };
  CHECK(red_over_green(false) > 1);
  CHECK(red_over_green(true) < -1);
}

TEST_CASE("white things under an even sky cannot be seen") {
  require_pocl();
  Scene scene = stage({Sphere{{0.4, 0.3, 0.5}, 0.8}, Sphere{{-0.9, 0, 1}, 0.5}, Box{{-1, -1.2, -1}, {1.5, -0.3, 1}}},
                      diffuse({1, 1, 1}));
  add(scene, ConstantLight{{1, 1, 1}});
  scene.integrator.name = "path";
  scene.sampler.sample_count = 256;
  for (const int rr_depth : {5, 100}) {
    scene.integrator.rr_depth = rr_depth;
    hold_mean(path_picture(scene).color, 1);
  }
}

/// Lights of every sort over the floor.
Scene many_lights() {
  Scene scene = stage({floor_plane(), Sphere{{0.5, 0.3, 0.4}, 0.4}}, diffuse({0.5, 0.6, 0.7}));
  add(scene, emitting(Sphere{{-1, 1, 1.5}, 0.2}, {4, 5, 6}));
  add(scene, emitting(Rectangle{{1, -1, 1}, {0, 0.5, 0}, {0.5, 0, 0.5}}, {1, 2, 1}));
  add(scene, PointLight{{-1, -1, 1}, {0.4, 0.2, 0.1}});
  add(scene, PointLight{{1, 1, 2}, {0.1, 0.4, 0.5}});
  add(scene, DirectionalLight{{0.2, 0.4, -1}, {0.3, 0.3, 0.3}});
  add(scene, ConstantLight{{0.2, 0.3, 0.5}});
  scene.sampler.sample_count = 256;
  scene.integrator.max_depth = 2;
  return scene;
}

TEST_CASE("one light drawn of all is as bright as each taken") {
  require_pocl();
  Scene scene = many_lights();
  Image difference = path_picture(scene).color;
  scene.integrator.name = "path";
  scene.sampler.seed = 1;
  const Image drawn = path_picture(scene).color;
  const double level = mean(difference).value;
  CHECK_FALSE(same_bits(drawn, difference));
  for (std::size_t i = 0; i < drawn.data.size(); ++i) difference.data[i] -= drawn.data[i];
  const Mean m = mean(difference);
  CHECK(std::fabs(m.value) < 4 * m.error);
  CHECK(m.error < 0.01 * level);
}

TEST_CASE("hide_emitters lets the camera look through what glows, but not what it lights") {
  require_pocl();
  Scene scene = stage({floor_plane()}, diffuse({0.5, 0.5, 0.5}));
  add(scene, emitting(Rectangle{{-2, -2, 1}, {0, 4, 0}, {4, 0, 0}}, {1, 1, 1}));
  add(scene, emitting(Sphere{{0, 0, 2}, 0.5}, {3, 3, 3}));
  add(scene, ConstantLight{{9, 9, 9}});
  scene.integrator.name = "path";
  scene.integrator.max_depth = 1;
  CHECK(lit_pixels(path_picture(scene).color) > 0);
  scene.integrator.hide_emitters = true;
  CHECK(lit_pixels(path_picture(scene).color) == 0);
  scene.integrator.max_depth = 2;
  const RenderResult lit = path_picture(scene);
  CHECK(lit_pixels(lit.color) == stage_size * stage_size);
}

// Mitsuba 3.9.1 too looks through it.
TEST_CASE("hide_emitters hides a surface that shines along its normals") {
  require_pocl();
  Scene scene =
      stage({Rectangle{{-9, -9, 0}, {18, 0, 0}, {0, 18, 0}}, Rectangle{{-2.5, -2.5, 3.5}, {0, 5, 0}, {5, 0, 0}}},
            diffuse({0.5, 0.5, 0.5}));
  scene.shapes[1].material = add(scene, Diffuse{{{0, 0, 0}}});
  scene.shapes[1].exitance = Rgb{1, 1, 1};
  add(scene, ConstantLight{{1, 1, 1}});
  scene.integrator.max_depth = 2;
  scene.sampler.kind = SamplerKind::independent;
  scene.sampler.sample_count = 16;
  scene.film.filter = {FilterKind::box, 0.5, 0.5};
  for (const char* integrator : {"path", "direct", "volpath", "bdpt"}) {
    INFO(integrator);
    scene.integrator.name = integrator;
    scene.integrator.hide_emitters = false;
    const std::size_t seen = lit_pixels(path_picture(scene).color);
    scene.integrator.hide_emitters = true;
    const std::size_t hidden = lit_pixels(path_picture(scene).color);
    CHECK(seen == 0);
    CHECK(hidden > 2000);
  }
}

}  // namespace
}  // namespace strahl::test
