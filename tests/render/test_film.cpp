// SPDX-License-Identifier: MIT
// A film without a guess about the scene (docs/decisions/0002-film.md): the brightness of lights, the size of a lamp of
// constant power, the size of the ground and the radiance of a far sun vary separately, over the range of floats, in
// every tier. The picture stays, and the error that it tells is its error. A program a tier; 40 s where none is cached.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "render/pictures.h"
#include "scene/model/build.h"

namespace strahl::test {
namespace {

/// So few that the noise is more than what grounds of 10 and of 10^7 reflect from the horizon.
constexpr int few = 16;

constexpr std::array all_tiers{Precision::fast, Precision::stable, Precision::robust, Precision::fp64};

/// What must not show.
struct Variant {
  double light = 1;          ///< All emitters are so many times as bright; the picture is compared divided by it.
  double lamp_radius = 0.1;  ///< Of a sphere of constant power.
  double ground = 10;        ///< Half the side of the square that everything stands on.
  double sun = 100;          ///< Radiance of a sphere that is 10^-9 wide in the sky, and out of sight.
};

/// The upper half of a sphere on a ground, lit by a lamp, a point light, a sky and a sun.
Scene scene_of(const Variant& v, int spp) {
  Scene scene;
  scene.materials = {Material{}};
  scene.integrator.name = "path";
  scene.integrator.max_depth = 3;
  add(scene, Sphere{{0, 0, 1}, 1});
  add(scene, Rectangle{{-v.ground, -v.ground, 0}, {2 * v.ground, 0, 0}, {0, 2 * v.ground, 0}});
  const double lamp = 2 * v.light / (v.lamp_radius * v.lamp_radius), sun = v.sun * v.light;
  add(scene, emitting(Sphere{{1, -2, 4}, v.lamp_radius}, {lamp, lamp / 2, lamp}));
  add(scene, emitting(Sphere{{6e5, 0, 8e5}, 1e-3}, {sun, sun, sun}));
  add(scene, PointLight{{2, -3, 3}, {3 * v.light, 3 * v.light, v.light}});
  add(scene, ConstantLight{{0.1 * v.light, 0.2 * v.light, 0.3 * v.light}});
  scene.camera.world_from_camera.m = {{{-1, 0, 0, 0}, {0, 0, 1, -6}, {0, 1, 0, 1.6}}};
  scene.camera.fov_degrees = 12;
  scene.film.width = scene.film.height = 10;
  scene.sampler.kind = SamplerKind::independent;
  scene.sampler.sample_count = spp;
  return scene;
}

double rmse(const Image& a, double factor, const Image& b) {
  double squares = 0;
  for (std::size_t i = 0; i < a.data.size(); ++i)
    squares += std::pow(static_cast<double>(a.data[i]) / factor - static_cast<double>(b.data[i]), 2);
  return std::sqrt(squares / static_cast<double>(a.data.size()));
}

RenderSettings tier(Precision precision) {
  RenderSettings settings;
  settings.precision = precision;
  return settings;
}

const Image& truth() {
  static const Image image = render("pocl", scene_of({}, 4096), tier(Precision::fp64)).color;
  return image;
}

/// Noise is told right, give or take luck; nothing but noise differs.
void hold(const Variant& v, Precision precision, const RenderResult& first) {
  const RenderResult result = render("pocl", scene_of(v, few), tier(precision));
  CAPTURE(precision_name(precision), v.light, v.lamp_radius, v.ground, v.sun);
  REQUIRE(result.error);
  REQUIRE(first.error);
  const double told = result.error->rmse / v.light, off = rmse(result.color, v.light, truth());
  CAPTURE(told, off);
  CHECK(off < 1.2 * result.error->rmse_high / v.light);
  CHECK(off > result.error->rmse_low / v.light / 1.2);
  CHECK(rmse(result.color, v.light, first.color) < 1.5 * std::hypot(told, first.error->rmse));
  CHECK(result.stats.unusual.not_finite() == 0);
}

TEST_CASE("lamps, grounds, suns and light of any size, one at a time and together") {
  require_pocl();
  for (const Precision precision : all_tiers) {
    const RenderResult first = render("pocl", scene_of({}, few), tier(precision));
    const auto each = [&](double Variant::*member, int from, int to) {
      for (int decade = from; decade <= to; ++decade) {
        Variant variant;
        variant.*member = std::pow(10.0, decade);
        hold(variant, precision, first);
      }
    };
    each(&Variant::lamp_radius, -8, -2);
    each(&Variant::ground, 2, 7);
    each(&Variant::sun, 3, 13);
    each(&Variant::light, -12, 12);
    std::mt19937 random(5);
    const auto decade = [&](int from, int to) {
      return std::pow(10.0, std::uniform_real_distribution<double>(from, to)(random));
    };
    for (int i = 0; i < 10; ++i) hold({decade(-10, 10), decade(-8, -1), decade(1, 7), decade(2, 13)}, precision, first);
  }
}

}  // namespace
}  // namespace strahl::test
