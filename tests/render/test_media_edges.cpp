// SPDX-License-Identifier: MIT
// Media where numbers are at their ends: the rows M01 ... of the catalogue (src/selftest/rows/media.txt). STRAHL_WALKS:
// how many walks of each body are counted; 2 million without it. 20 s.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <string>

#include "render/filled.h"
#include "scene/model/build.h"
#include "selftest/closed_meshes.h"

namespace strahl::test {
namespace {

constexpr MediumBoundary filling{0, -1};

double seen(const Scene& scene, int channel = 0) {
  return static_cast<double>(color(scene, Precision::robust).at(22, 25, channel));
}

Medium grey(double sigma_t, double albedo) { return medium({sigma_t, sigma_t, sigma_t}, {albedo, albedo, albedo}); }

/// Two sheets that face away from each other, from z = low to high.
std::vector<Geometry> sheets(double low, double high, double half = 2) {
  return {Rectangle{{-half, -half, high}, {2 * half, 0, 0}, {0, 2 * half, 0}},
          Rectangle{{-half, -half, low}, {0, 2 * half, 0}, {2 * half, 0, 0}}};
}

Cube cube_between(const Vec3& low, const Vec3& high) {
  return {low, {{{high.x - low.x, 0, 0}, {0, high.y - low.y, 0}, {0, 0, high.z - low.z}}}};
}

Geometry body(int kind, const Vec3& low, const Vec3& high) {
  if (kind == 0) return Box{low, high};
  return kind == 1 ? Geometry(cube_between(low, high)) : block(low, high);
}

/// Bodies of media, each of its own, in white surroundings.
Scene bodies(const std::vector<Geometry>& shapes, const std::vector<Medium>& media) {
  Scene scene = filled(shapes.front(), media.front());
  scene.media = media;
  for (std::size_t i = 1; i < shapes.size(); ++i) {
    add(scene, shapes[i]);
    const int inside = static_cast<int>(std::min(i, media.size() - 1));
    scene.shapes.back().media = MediumBoundary{inside, -1};
  }
  return scene;
}

TEST_CASE("M01: optical depths from 1e-8 to 1e4") {
  require_pocl();
  for (const double depth : {1e-8, 1e-4, 1.0, 80.0, 1e4}) {
    INFO(depth);
    CHECK(seen(filled(slab(1), grey(depth, 0))) == Approx(std::exp(-depth)).epsilon(1e-5).margin(1e-38));
    Medium glowing = grey(depth, 0);
    glowing.emission = Rgb{1, 1, 1};
    CHECK(seen(filled(slab(1), glowing, 0)) == Approx(-std::expm1(-depth)).epsilon(1e-5));
    if (depth < 10) CHECK(mean_of(drawn(filled(slab(1), grey(depth, 1)), 32)).r == Approx(1).margin(8e-3));
  }
  // Chandrasekhar's half space of albedo 1/2: 1 - sqrt(1/2) H(1), H(1) = 1.2512560.
  CHECK(mean_of(drawn(filled(slab(1), grey(1e4, 0.5)), 256)).r == Approx(0.11523).epsilon(0.01));
}

TEST_CASE("M02: an albedo of 1 - 1e-7") {
  require_pocl();
  Scene scene = filled(Sphere{{0, 0, 0}, 1}, grey(20, 1 - 1e-7));
  scene.integrator.rr_depth = 4096;
  CHECK(mean_of(drawn(scene, 32)).r == Approx(1).margin(8e-3));
}

TEST_CASE("M03: light that goes on, or back, almost as it came") {
  require_pocl();
  for (const double g : {0.999, -0.999}) {
    Medium peaked = grey(3, 1);
    peaked.phases = {{PhaseFunction::Kind::hg, 1, g}};
    INFO(g);
    CHECK(mean_of(drawn(filled(Sphere{{0, 0, 0}, 1}, peaked), 64)).r == Approx(1).margin(8e-3));
  }
}

TEST_CASE("M04: bodies that touch, whichever is named first") {
  require_pocl();
  const Vec3 below_low{-2, -2, -1.1}, below_high{2, 2, 0.1}, above_low{-2, -2, 0.1}, above_high{2, 2, 0.8};
  const double below = 1.2 * 0.9, above = 0.7 * 0.3;
  for (const int kind : {0, 1, 2})
    for (const bool is_turned : {false, true}) {
      INFO(kind << is_turned);
      const Geometry low = body(kind, below_low, below_high), high = body(kind, above_low, above_high);
      const Medium dense = grey(0.9, 0), thin = grey(0.3, 0);
      const Scene scene = is_turned ? bodies({high, low}, {thin, dense}) : bodies({low, high}, {dense, thin});
      CHECK(seen(scene) == Approx(std::exp(-below - above)).epsilon(1e-5));
      // Of one medium.
      CHECK(seen(is_turned ? bodies({high, low}, {dense}) : bodies({low, high}, {dense})) ==
            Approx(std::exp(-1.9 * 0.9)).epsilon(1e-5));
    }
}

TEST_CASE("M08: bodies that lie on one another") {
  require_pocl();
  const Vec3 low{-2, -2, -0.5}, high{2, 2, 0.5};
  for (const Geometry& both :
       {body(0, low, high), body(1, low, high), body(2, low, high), Geometry(Sphere{{0, 0, 0}, 1})}) {
    INFO(both.index());
    // Whatever is there, the way through them has an end, and either medium is left.
    const double seen_through = seen(bodies({both, both}, {grey(0.7, 0)}));
    CHECK(seen_through == Approx(seen(bodies({both}, {grey(0.7, 0)}))).epsilon(1e-5));
  }
}

TEST_CASE("M05: the camera stands on a boundary") {
  require_pocl();
  const Vec3 low{-2, -2, -0.5}, high{2, 2, 0.5};
  for (const Geometry& geometry : {Geometry(cube_between(low, high)), Geometry(block(low, high))}) {
    INFO(geometry.index());
    Scene scene = filled(geometry, grey(0.7, 0));
    scene.camera.world_from_camera.m = {{{-1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, -1, 0.5}}};
    scene.camera.medium = 0;
    CHECK(seen(scene) == Approx(std::exp(-0.7)).epsilon(1e-5));
    // Outwards, from the other side.
    scene.camera.world_from_camera.m = {{{-1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, -1, -0.5}}};
    scene.camera.medium = -1;
    CHECK(seen(scene) == 1);
  }
}

TEST_CASE("M06: a body thinner than the step with which rays leave surfaces") {
  require_pocl();
  // The thickness is 8 units in the last place of the distance.
  const double thickness = 0x1p-18;
  const Vec3 low{-2, -2, 0}, high{2, 2, thickness};
  const std::vector<std::vector<Geometry>> all = {
      {cube_between(low, high)}, {block(low, high)}, sheets(0, thickness), sheets(0, thickness, 200)};
  for (const auto& shapes : all) {
    INFO(shapes.size() << " of " << shapes.front().index());
    CHECK(seen(bodies(shapes, {grey(0.7 / thickness, 0)})) == Approx(std::exp(-0.7)).epsilon(1e-4));
  }
}

/// How many of the walks through bodies that only scatter do not come out. Each brings 1 of the white surroundings,
/// which no shadow ray asks for: they have no weight among the lights.
double lost(Scene scene, double walks) {
  scene.lights.front().sampling_weight = 0;
  add(scene, PointLight{{0, 0, 9}, {1e-30, 1e-30, 1e-30}});
  scene.integrator.max_depth = 20000;
  scene.integrator.rr_depth = 20000;
  scene.sampler.kind = SamplerKind::independent;
  const int samples = static_cast<int>(std::ceil(walks / (stage_size * stage_size)));
  scene.sampler.sample_count = samples;
  RenderSettings settings = stage_settings(Precision::robust);
  settings.light_choice = "power";
  const Image image = render("pocl", scene, settings).color;
  double missing = 0;
  for (const float value : image.data) missing += (1 - static_cast<double>(value)) / 3;
  return missing * samples;
}

TEST_CASE("M07: no walk gets lost in a closed medium, or runs for ever") {
  require_pocl();
  const char* asked = std::getenv("STRAHL_WALKS");
  const double walks = asked == nullptr ? 1e6 : std::stod(asked);
  const Geometry bodies[] = {Sphere{{0, 0, 0}, 1.5}, cube_between({-1.5, -1.3, -1}, {1.5, 1.3, 1}),
                             selftest::icosphere({0.1, 0.2, 0}, 1.7, 2).scene.shapes.front().geometry};
  for (const Geometry& body : bodies) {
    INFO(body.index());
    CHECK(std::abs(lost(filled(body, grey(4, 1)), walks)) < 0.5);
  }
}

}  // namespace
}  // namespace strahl::test
