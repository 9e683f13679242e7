// SPDX-License-Identifier: MIT
// The checkerboard on a plane, in a mirror under a sky of 1, so that a pixel is the texture's value exactly.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "render/stage.h"

namespace strahl::test {
namespace {

Scene board(const std::array<double, 6>& to_uv) {
  Scene scene = stage({floor_plane()});
  scene.textures = {{"", Checkerboard{{1, 0.75, 0.5}, {0.25, 0.125, 0}, to_uv}, {}}};
  scene.materials[0].bsdf = Conductor{{{1, 1, 1}, 0}};
  scene.integrator.name = "whitted";
  scene.lights = {light(ConstantLight{})};
  return scene;
}

double fraction(double x) { return x - std::floor(x); }

TEST_CASE("squares of 1/2, on both sides of 0, by Mitsuba's rule") {
  require_pocl();
  // A pixel is 1/12 wide, below half a square.
  for (const std::array<double, 6>& m : {std::array<double, 6>{1, 0, 0, 0, 1, 0}, {0.5, 0.25, 0.01, -0.25, 0.5, -7.77}})
    for (const Precision precision : asked_tiers()) {
      const Image image = color(board(m), precision);
      int first = 0;
      for (int y = 0; y < stage_size; ++y)
        for (int x = 0; x < stage_size; ++x) {
          const double u = m[0] * stage_x(x) + m[1] * stage_y(y) + m[2];
          const double v = m[3] * stage_x(x) + m[4] * stage_y(y) + m[5];
          if (std::fabs(u * 2 - std::round(u * 2)) < 1e-5 || std::fabs(v * 2 - std::round(v * 2)) < 1e-5) continue;
          const bool one = (fraction(u) > 0.5) == (fraction(v) > 0.5);
          first += one ? 1 : 0;
          INFO(x << ", " << y << ": " << u << ", " << v << ", " << precision_name(precision));
          REQUIRE(image.at(x, y, 0) == (one ? 1.0F : 0.25F));
          REQUIRE(image.at(x, y, 1) == (one ? 0.75F : 0.125F));
          REQUIRE(image.at(x, y, 2) == (one ? 0.5F : 0.0F));
        }
      CHECK(first > stage_size * stage_size / 3);
      CHECK(first < stage_size * stage_size * 2 / 3);
    }
}

TEST_CASE("a pixel wider than half a square shows the mean over its own size") {
  require_pocl();
  // Six squares a pixel: exactly as much of one colour as of the other.
  const Image even = color(board({36, 0, 0, 0, 36, 0}), asked_tiers().back());
  for (std::size_t i = 0; i < even.data.size(); i += 3) REQUIRE(even.data[i] == Approx(0.625).epsilon(1e-6));
  // One square and a bit.
  const double scale = 6.1, width = scale / 12;
  const Image odd = color(board({scale, 0, 0, 0, scale, 0}), asked_tiers().back());
  const auto wave = [&](double x) {  // The mean of +1 and -1 over a pixel's width, in steps.
    int total = 0;
    for (int i = 0; i < 10000; ++i) total += fraction(x + width * ((i + 0.5) / 10000 - 0.5)) > 0.5 ? -1 : 1;
    return total / 10000.;
  };
  double contrast = 0;
  for (int y = 0; y < stage_size; y += 5)
    for (int x = 0; x < stage_size; x += 5) {
      const double share = 0.5 + 0.5 * wave(scale * stage_x(x)) * wave(scale * stage_y(y));
      REQUIRE(odd.at(x, y, 0) == Approx(0.25 + 0.75 * share).margin(2e-3));
      contrast = std::max(contrast, std::fabs(share - 0.5));
    }
  CHECK(contrast > 0.1);
}

TEST_CASE("samples that are spread filter by themselves: the board is not blurred a second time") {
  require_pocl();
  const double scale = 6.1, width = scale / 12;
  Scene scene = board({scale, 0, 0, 0, scale, 0});
  scene.sampler.kind = SamplerKind::sobol;
  scene.sampler.sample_count = 1024;
  scene.film.filter = {FilterKind::box, 0.5, 0.5};
  scene.film.crop = Window{3, 3, 9, 9};
  const Image image = color(scene, asked_tiers().back());
  const auto wave = [&](double x) {
    int total = 0;
    for (int i = 0; i < 10000; ++i) total += fraction(x + width * ((i + 0.5) / 10000 - 0.5)) > 0.5 ? -1 : 1;
    return total / 10000.;
  };
  for (int y = 0; y < 6; ++y)
    for (int x = 0; x < 6; ++x) {
      const double share = 0.5 + 0.5 * wave(scale * stage_x(x + 3)) * wave(scale * stage_y(y + 3));
      REQUIRE(image.at(x, y, 0) == Approx(0.25 + 0.75 * share).margin(0.01));
    }
}

TEST_CASE("towards the horizon the board fades to even grey") {
  require_pocl();
  constexpr int size = 96;
  Scene scene = small_scene(scene_folder / "accuracy/checkerboard.xml", size, size, 1);
  scene.sampler.kind = SamplerKind::centre;
  for (const Precision precision : asked_tiers()) {
    RenderSettings settings;
    settings.precision = precision;
    const Image image = render("pocl", scene, settings).color;
    int horizon = 0;
    while (image.at(0, horizon, 0) == 0) ++horizon;
    CHECK(horizon > 20);
    const auto range = [&](int row) {
      double low = 1e9, high = 0;
      for (int x = 0; x < size; ++x) {
        low = std::min(low, double{image.at(x, row, 0)});
        high = std::max(high, double{image.at(x, row, 0)});
      }
      return std::pair(low, high);
    };
    CHECK(range(horizon - 1).second == 0);
    CHECK(range(horizon).first > 0.4);
    CHECK(range(horizon).second < 1.01 * range(horizon).first);
    CHECK(range(size - 1).second > 5 * range(size - 1).first);
  }
}

}  // namespace
}  // namespace strahl::test
