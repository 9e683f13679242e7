// SPDX-License-Identifier: MIT
// Media in closed form: what is absorbed, what is emitted, furnaces of every phase function, a published slab; and the
// same bits however paths are followed. 20 s.
#include <catch2/catch.hpp>
#include <cmath>

#include "render/filled.h"
#include "scene/model/build.h"

namespace strahl::test {
namespace {

TEST_CASE("a medium that only absorbs lets e^-depth through") {
  require_pocl();
  for (const double depth : {1e-8, 1e-3, 0.7, 5.0, 40.0}) {
    const Image image = color(filled(slab(1), medium({depth, 2 * depth, depth / 2}, {0, 0, 0})), Precision::robust);
    INFO(depth);
    CHECK(static_cast<double>(image.at(10, 20, 0)) == Approx(std::exp(-depth)).epsilon(5e-6));
    CHECK(static_cast<double>(image.at(10, 20, 1)) == Approx(std::exp(-2 * depth)).epsilon(1e-5));
    CHECK(static_cast<double>(image.at(10, 20, 2)) == Approx(std::exp(-depth / 2)).epsilon(5e-6));
  }
  const Image ball = color(filled(Sphere{{0, 0, 0}, 1}, medium({2, 2, 2}, {0, 0, 0})), Precision::robust);
  for (const int column : {24, 30, 34}) {
    const double x = stage_x(column), y = stage_y(24), chord = 2 * std::sqrt(1 - x * x - y * y);
    CHECK(static_cast<double>(ball.at(column, 24, 0)) == Approx(std::exp(-2 * chord)).epsilon(1e-5));
  }
}

TEST_CASE("at its last depth a path still finds the light behind surfaces that do not count") {
  require_pocl();
  Scene seen = filled(slab(1), medium({0.7, 0.7, 0.7}, {0, 0, 0}));
  seen.integrator.max_depth = 1;
  CHECK(static_cast<double>(color(seen, Precision::robust).at(10, 20, 0)) == Approx(std::exp(-0.7)).epsilon(5e-6));
  Scene furnace = filled(slab(1), medium({1e-6, 1e-6, 1e-6}, {0, 0, 0}));
  furnace.materials.push_back(diffuse({1, 1, 1}));
  furnace.shapes.emplace_back();
  furnace.shapes.back().geometry = floor_plane();
  furnace.shapes.back().material = 1;
  furnace.integrator.max_depth = 2;
  CHECK(mean_of(drawn(furnace, 64)).g == Approx(1).margin(4e-3));
}

TEST_CASE("a medium that emits shows 1 - e^-depth of its radiance") {
  require_pocl();
  for (const double depth : {1e-6, 0.1, 3.0}) {
    Medium glowing = medium({depth, depth, depth}, {0, 0, 0});
    glowing.emission = Rgb{2, 3, 4};
    const Image image = color(filled(slab(1), glowing, 0), Precision::robust);
    INFO(depth);
    CHECK(static_cast<double>(image.at(5, 7, 0)) == Approx(-2 * std::expm1(-depth)).epsilon(1e-5));
    CHECK(static_cast<double>(image.at(5, 7, 2)) == Approx(-4 * std::expm1(-depth)).epsilon(1e-5));
  }
}

TEST_CASE("a medium that only scatters is not seen in white surroundings") {
  require_pocl();
  using Kind = PhaseFunction::Kind;
  for (const std::vector<PhaseFunction>& phases : {std::vector<PhaseFunction>{{Kind::isotropic}},
                                                   {{Kind::hg, 1, 0.9}},
                                                   {{Kind::hg, 1, -0.6}},
                                                   {{Kind::rayleigh}},
                                                   {{Kind::hg, 0.3, 0.7}, {Kind::rayleigh, 0.7}}}) {
    Medium white = medium({1, 2, 3}, {1, 1, 1});
    white.phases = phases;
    check_unseen(white);
  }
}

TEST_CASE("a slab reflects and transmits as van de Hulst has it") {
  require_pocl();
  Medium published = medium({2, 2, 2}, {0.9, 0.9, 0.9});
  published.phases = {{PhaseFunction::Kind::hg, 1, 0.75}};
  const Rgb mean = mean_of(drawn(filled(slab(1), published), 128));
  CHECK(mean.r == Approx(0.09739 + 0.66096).margin(3e-3));
}

TEST_CASE("paths through media and masks are the same one by one and in lanes") {
  Scene scene = filled(Sphere{{0, 0, 0}, 1}, medium({1, 2, 4}, {0.9, 0.6, 0.8}));
  add(scene, floor_plane(), add(scene, Diffuse{{{0.5, 0.4, 0.3}}}));
  // Between the camera and half of the picture, so that groups of paths hold both.
  Material veil = diffuse({0.3, 0.3, 0.3}, true);
  veil.opacity = Reflectance{{0.5, 0.5, 0.5}};
  scene.materials.push_back(veil);
  for (const double z : {2.0, 2.5})
    add(scene, Rectangle{{-2, -2, z}, {2, 0, 0}, {0, 4, 0}}, static_cast<int>(scene.materials.size()) - 1);
  // Boundaries of other kinds: a mesh that touches the ball's medium, a box that touches the mesh.
  scene.media.push_back(medium({2, 0.5, 1}, {0.5, 0.9, 0.9}));
  for (const Geometry& body :
       {Geometry(block({-1.4, -1, -0.5}, {-0.6, 1, 0.5})), Geometry(Box{{-2, -1, -0.5}, {-1.4, 1, 0.5}})}) {
    add(scene, body, scene.shapes.front().material);
    scene.shapes.back().media = MediumBoundary{1, -1};
  }
  check_in_lanes(scene);
}

TEST_CASE("a path that scatters within glass of a priority crosses no surface there") {
  require_pocl();
  Material glass;
  glass.bsdf = Dielectric{1.5, 1};
  Scene scene = stage({Sphere{{0, 0, 0}, 1}, Sphere{{0.4, 0, 0}, 0.8}}, glass);
  scene.media = {medium({2, 2, 2}, {1, 1, 1})};
  scene.integrator.name = "volpath";
  scene.lights = {light(ConstantLight{{1, 1, 1}})};
  for (std::size_t i = 0; i < 2; ++i) {
    scene.shapes[i].priority = static_cast<int>(i);
    scene.shapes[i].media = MediumBoundary{0, -1};
  }
  std::get<Dielectric>(scene.materials.emplace_back(glass).bsdf).int_ior = 1.2;
  scene.shapes[1].material = 1;
  CHECK(mean_of(drawn(scene, 256)).r == Approx(1).margin(6e-3));
}

TEST_CASE("at max_depth 0 a medium that emits is black, as all else is") {
  require_pocl();
  Medium glowing = medium({1, 1, 1}, {0, 0, 0});
  glowing.emission = Rgb{1, 1, 1};
  Scene scene = filled(slab(1), glowing);
  scene.integrator.max_depth = 0;
  CHECK(mean_of(color(scene, Precision::robust)).g == 0);
  scene.integrator.max_depth = 1;
  CHECK(mean_of(color(scene, Precision::robust)).g == Approx(1).epsilon(1e-5));
}

}  // namespace
}  // namespace strahl::test
