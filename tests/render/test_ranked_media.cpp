// SPDX-License-Identifier: MIT
// Bodies with a priority that overlap: each place is in the medium of the highest of them. In closed form: what is
// absorbed, whether bodies are glass, mere boundaries or parts of an instance; what layers reflect; furnaces. 15 s.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "render/filled.h"
#include "scene/model/build.h"

namespace strahl::test {
namespace {

constexpr double first = 0.3, second = 1.1;  // What a unit of length of each medium absorbs.

/// Glass of the index of what is around it: seen by media alone, and met as a surface.
Material clear_glass() {
  Material glass;
  glass.bsdf = Dielectric{1.5, 1.5};
  return glass;
}

Cube layer(double low, double high) { return {{-100, -100, low}, {{{200, 0, 0}, {0, 200, 0}, {0, 0, high - low}}}}; }

/// From -1 to 0.5, and from -0.5 to 1.
Scene two_layers(const Material& one, const Material& other, int priority_of_first) {
  Scene scene = stage({layer(-1, 0.5), layer(-0.5, 1)}, one);
  scene.materials.push_back(other);
  scene.shapes[1].material = 1;
  scene.media = {medium({first, first, first}, {0, 0, 0}), medium({second, second, second}, {0, 0, 0})};
  for (int i = 0; i < 2; ++i) scene.shapes[static_cast<std::size_t>(i)].media = MediumBoundary{i, -1};
  scene.shapes[0].priority = priority_of_first;
  scene.shapes[1].priority = 0;
  scene.integrator.name = "volpath";
  scene.integrator.rr_depth = 100;
  scene.lights = {light(ConstantLight{{1, 1, 1}})};
  return scene;
}

double light_through(const Scene& scene) { return static_cast<double>(color(scene, Precision::robust).at(10, 20, 0)); }

TEST_CASE("of two bodies that overlap the one of the higher priority is there") {
  require_pocl();
  for (const Material& one : {boundary(), clear_glass()})
    for (const Material& other : {boundary(), clear_glass()})
      for (const int priority : {1, -1}) {
        INFO(one.opacity.has_value() << other.opacity.has_value() << " priority " << priority);
        Scene scene = two_layers(one, other, priority);
        const double of_first = priority > 0 ? 1.5 : 0.5;
        const double expected = std::exp(-first * of_first - second * (2 - of_first));
        CHECK(light_through(scene) == Approx(expected).epsilon(5e-6));
        std::reverse(scene.shapes.begin(), scene.shapes.end());
        CHECK(light_through(scene) == Approx(expected).epsilon(5e-6));
        // From the other side, and in the middle of both a body of nothing.
        for (Shape& shape : scene.shapes) std::get<Cube>(shape.geometry).corner.z *= -1;
        for (Shape& shape : scene.shapes) std::get<Cube>(shape.geometry).corner.z -= 1.5;
        CHECK(light_through(scene) == Approx(expected).epsilon(5e-6));
        add(scene, layer(-0.3, 0.3), 1 - scene.shapes[0].material);
        scene.shapes.back().priority = 2;
        scene.shapes.back().media = MediumBoundary{-1, -1};
        CHECK(light_through(scene) == Approx(expected * std::exp(0.6 * (priority > 0 ? first : second))).epsilon(5e-6));
      }
}

TEST_CASE("light of a lamp loses what the highest bodies on its way absorb") {
  require_pocl();
  for (const int priority : {1, -1}) {
    Scene scene = two_layers(boundary(), boundary(), priority);
    scene.lights = {light(DirectionalLight{{0, 0, -1}, {2, 2, 2}})};
    add(scene, Rectangle{{-5, -5, -2}, {10, 0, 0}, {0, 10, 0}}, add(scene, Diffuse{{{0.5, 0.5, 0.5}}}));
    const double of_first = priority > 0 ? 1.5 : 0.5, depth = first * of_first + second * (2 - of_first);
    CHECK(light_through(scene) == Approx(std::exp(-2 * depth) / std::acos(-1.0)).epsilon(2e-5));
  }
}

// What names no medium has none within it, and behind it is what was there before.
TEST_CASE("glass in fog displaces it") {
  require_pocl();
  Scene scene = stage({layer(-1, 0.5)}, clear_glass());
  scene.media = {medium({first, first, first}, {0, 0, 0})};
  scene.camera.medium = 0;
  scene.integrator.name = "volpath";
  add(scene, Rectangle{{-5, -5, -2}, {10, 0, 0}, {0, 10, 0}});
  scene.shapes.back().radiance = Rgb{1, 1, 1};
  const double fog = light_through(scene);
  scene.shapes.front().priority = 0;
  CHECK(light_through(scene) == Approx(fog * std::exp(1.5 * first)).epsilon(1e-5));
}

/// Fog without a priority, above or below z = 0, and a body with one from -0.5 to 0.5 that reaches into it.
Scene half_in_fog(const Material& body, bool is_above) {
  Scene scene = two_layers(boundary(), body, 0);
  scene.shapes[0].geometry = is_above ? layer(0, 1) : layer(-1, 0);
  scene.shapes[1].geometry = layer(-0.5, 0.5);
  scene.shapes[0].priority.reset();
  return scene;
}

TEST_CASE("fog into which glass with a priority reaches is around the glass, and not within it") {
  require_pocl();
  for (const bool is_above : {false, true}) {
    Scene scene = half_in_fog(clear_glass(), is_above);
    scene.shapes[1].media.reset();
    CHECK(light_through(scene) == Approx(std::exp(-0.5 * first)).epsilon(5e-6));
    std::reverse(scene.shapes.begin(), scene.shapes.end());
    CHECK(light_through(scene) == Approx(std::exp(-0.5 * first)).epsilon(5e-6));
  }
}

TEST_CASE("a body with a priority stays full of its medium where fog ends within it") {
  require_pocl();
  Material pane;
  pane.bsdf = ThinDielectric{{1, 1}};
  for (const Material& material : {boundary(), clear_glass(), pane}) {
    INFO(material.opacity.has_value() << material.bsdf.index());
    Scene scene = half_in_fog(material, true);
    const double down = std::exp(-0.5 * first - second);
    CHECK(light_through(scene) == Approx(down).epsilon(5e-6));
    std::reverse(scene.shapes.begin(), scene.shapes.end());
    CHECK(light_through(scene) == Approx(down).epsilon(5e-6));
    if (std::holds_alternative<Dielectric>(material.bsdf)) continue;
    // Shadow rays do not pass glass. Upwards the body is left for its exterior, which is none.
    scene.lights = {light(DirectionalLight{{0, 0, -1}, {2, 2, 2}})};
    add(scene, Rectangle{{-5, -5, -2}, {10, 0, 0}, {0, 10, 0}}, add(scene, Diffuse{{{0.5, 0.5, 0.5}}}));
    CHECK(light_through(scene) == Approx(down * std::exp(-second) / std::acos(-1.0)).epsilon(2e-5));
  }
}

TEST_CASE("bodies of an instance overlap as others do") {
  require_pocl();
  for (const int priority : {1, -1}) {
    Scene scene = two_layers(boundary(), boundary(), priority);
    scene.groups.push_back({"", {scene.shapes[0]}, {}});
    scene.instances.push_back({});
    scene.shapes.erase(scene.shapes.begin());
    const double of_first = priority > 0 ? 1.5 : 0.5;
    CHECK(light_through(scene) == Approx(std::exp(-first * of_first - second * (2 - of_first))).epsilon(5e-6));
  }
}

double reflected_upright(double a, double b) { return (a - b) * (a - b) / ((a + b) * (a + b)); }

/// Of a layer that reflects r on either side and lets t through, and one below it: what both reflect upwards and
/// downwards, and let through.
struct Layer {
  double up, down, through;
};
Layer on(const Layer& a, const Layer& b) {
  const double between = 1 / (1 - a.down * b.up);
  return {a.up + a.through * a.through * b.up * between, b.down + b.through * b.through * a.down * between,
          a.through * b.through * between};
}
Layer face(double above, double below) {
  return {reflected_upright(above, below), reflected_upright(above, below), 1 - reflected_upright(above, below)};
}
Layer absorber(double depth) { return {0, 0, std::exp(-depth)}; }

TEST_CASE("glass on a liquid, each with a medium, reflects and transmits what layers do") {
  require_pocl();
  for (const int priority : {1, -1}) {
    Material glass, liquid;
    glass.bsdf = Dielectric{1.8, 1};
    liquid.bsdf = Dielectric{1.3, 1};
    Scene scene = two_layers(glass, liquid, priority);
    scene.integrator.max_depth = 60;
    // The camera looks down: the liquid comes first.
    const double of_first = priority > 0 ? 1.5 : 0.5;
    Layer all = on(face(1, 1.3), absorber(second * (2 - of_first)));
    all = on(all, on(face(1.3, 1.8), on(absorber(first * of_first), face(1.8, 1))));
    // Light from below is as white as that from above.
    CHECK(mean_of(drawn(scene, 256)).r == Approx(all.up + all.through).margin(3e-3));
  }
}

TEST_CASE("bodies that only scatter are not seen where they overlap either, in lanes and one by one") {
  require_pocl();
  Scene scene =
      stage({Sphere{{-0.3, 0, 0}, 1}, Sphere{{0.5, 0, 0}, 0.8}, Box{{-0.5, -1.2, -0.5}, {0.6, 0.6, 0.6}}}, boundary());
  scene.materials.push_back(clear_glass());
  scene.media = {medium({1, 2, 3}, {1, 1, 1}), medium({4, 2, 1}, {1, 1, 1}), medium({0.5, 5, 0.5}, {1, 1, 1})};
  for (int i = 0; i < 3; ++i) {
    scene.shapes[static_cast<std::size_t>(i)].media = MediumBoundary{i, -1};
    scene.shapes[static_cast<std::size_t>(i)].priority = i == 0 ? 1 : 2 - i;
  }
  scene.shapes[1].material = 1;
  scene.integrator.name = "volpath";
  scene.lights = {light(ConstantLight{{1, 1, 1}})};
  const Rgb mean = mean_of(drawn(scene, 64));
  CHECK(mean.r == Approx(1).margin(5e-3));
  CHECK(mean.g == Approx(1).margin(5e-3));
  check_in_lanes(scene, true);
}

}  // namespace
}  // namespace strahl::test
