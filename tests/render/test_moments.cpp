// SPDX-License-Identifier: MIT
// Second moments (integrator moment): the mean of the squares of each pixel's samples, with the bits of the picture
// however the samples are split.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "packing/cl_layout.h"
#include "render/film_state.h"
#include "render/pictures.h"

namespace strahl::test {
namespace {

constexpr int sample_count = 12;

Scene lamp_room() {
  Scene scene = small_scene(scene_folder / "cornell/cornell-box.xml", 16, 12, sample_count);
  scene.sampler.kind = SamplerKind::independent;
  return scene;
}

RenderSettings with_moments(Precision precision = Precision::robust) {
  RenderSettings settings;
  settings.precision = precision;
  settings.aovs.add(NamedAov{"p", Aov::xyz});
  settings.aovs.add(NamedAov{"m2_p", Aov::xyz_squared});
  return settings;
}

/// Component 0 to 5 of a pixel: X, Y, Z and the means of their squares.
double at(const Image& moments, std::size_t pixel, std::size_t component) {
  return moments.data[pixel * 6 + component];
}

bool same(const RenderResult& a, const RenderResult& b) {
  return same_bits(a.color, b.color) && same_bits(a.named_aov, b.named_aov);
}

}  // namespace

TEST_CASE("the squares of single samples have the mean that all have together") {
  require_pocl();
  RenderSettings settings = with_moments();
  settings.disabled = without_sharing;  // So that a pixel's sample is one.
  Renderer renderer(Device::open("pocl"), lamp_room(), settings);
  const Image whole = renderer.render().named_aov;
  REQUIRE(whole.channels == std::vector<std::string>{"p.X", "p.Y", "p.Z", "m2_p.X", "m2_p.Y", "m2_p.Z"});
  std::vector<double> sums(whole.data.size());
  for (int sample = 0; sample < sample_count; ++sample) {
    RenderGoal goal;
    goal.samples = SampleRange{sample, 1};
    const RenderResult one = renderer.render({}, goal);
    for (std::size_t pixel = 0; pixel < sums.size() / 6; ++pixel) {
      const float* rgb = &one.color.data[pixel * 3];
      const double y = 0.212671 * rgb[0] + 0.715160 * rgb[1] + 0.072169 * rgb[2];
      CHECK(at(one.named_aov, pixel, 1) == Approx(y).epsilon(1e-6));
      for (std::size_t c = 0; c < 3; ++c) {
        const double mean = at(one.named_aov, pixel, c);
        CHECK(at(one.named_aov, pixel, c + 3) == Approx(mean * mean).epsilon(1e-6));
        sums[pixel * 6 + c] += mean / sample_count;
        sums[pixel * 6 + c + 3] += mean * mean / sample_count;
      }
    }
  }
  bool varies = false;
  for (std::size_t i = 0; i < sums.size(); ++i) CHECK(whole.data[i] == Approx(sums[i]).epsilon(1e-5));
  for (std::size_t pixel = 0; pixel < sums.size() / 6; ++pixel)
    varies = varies || at(whole, pixel, 4) > 1.5 * at(whole, pixel, 1) * at(whole, pixel, 1);
  CHECK(varies);
}

TEST_CASE("squares of shared samples are weighted as the samples are") {
  require_pocl();
  Scene scene = lamp_room();
  scene.sampler.sample_count = 256;
  RenderSettings alone = with_moments();
  alone.disabled = without_sharing;
  const Image shared = render("pocl", scene, with_moments()).named_aov;
  const Image expected = render("pocl", scene, alone).named_aov;
  double sum = 0, expected_sum = 0;
  for (std::size_t pixel = 0; pixel < shared.data.size() / 6; ++pixel) {
    for (std::size_t c = 0; c < 3; ++c)
      CHECK(at(shared, pixel, c + 3) >= at(shared, pixel, c) * at(shared, pixel, c) * (1 - 1e-6));
    if (pixel < shared.data.size() / 12) continue;  // The lamp is in the upper half.
    sum += at(shared, pixel, 4);
    expected_sum += at(expected, pixel, 4);
  }
  CHECK(sum == Approx(expected_sum).epsilon(0.05));
}

TEST_CASE("the picture is as without them, and they do not depend on lanes, passes or devices") {
  require_pocl();
  const RenderResult all = render("pocl", lamp_room(), with_moments());
  CHECK(same_bits(all.color, render("pocl", lamp_room(), {}).color));
  RenderSettings one = with_moments(), no_error = with_moments();
  one.lanes = 1;
  one.passes = 5;
  no_error.estimate_error = false;
  CHECK(same(all, render("pocl", lamp_room(), one)));
  CHECK(same(all, render("pocl", lamp_room(), no_error)));
  Renderer shared(Device::open("pocl"), lamp_room(), with_moments());
  shared.share_with(Device::open("pocl"));
  CHECK(same(all, shared.render()));
}

TEST_CASE("in double they are the same but for rounding", "[slow]") {
  require_pocl();
  RenderSettings alone = with_moments(), exact_alone = with_moments(Precision::fp64);
  alone.disabled = exact_alone.disabled = without_sharing;  // A weight may be rounded to another unit.
  const Image near = render("pocl", lamp_room(), alone).named_aov;
  const Image exact = render("pocl", lamp_room(), exact_alone).named_aov;
  for (std::size_t i = 0; i < exact.data.size(); ++i) CHECK(near.data[i] == Approx(exact.data[i]).epsilon(1e-4));
}

TEST_CASE("samples that are all alike") {
  require_pocl();
  Scene scene = lamp_room();
  scene.sampler.kind = SamplerKind::centre;
  scene.integrator.name = "normals";
  const RenderResult result = render("pocl", scene, with_moments());
  REQUIRE(lit_pixels(result.color) > 0);
  for (std::size_t pixel = 0; pixel < result.color.data.size() / 3; ++pixel)
    for (std::size_t c = 0; c < 3; ++c) {
      const double mean = at(result.named_aov, pixel, c);
      CHECK(at(result.named_aov, pixel, c + 3) == Approx(mean * mean).epsilon(1e-6));
    }
}

TEST_CASE("a picture goes on from its film, and films without them do not fit") {
  require_pocl();
  Renderer renderer(Device::open("pocl"), lamp_room(), with_moments());
  const RenderResult whole = renderer.render();
  std::optional<FilmState> kept;
  FilmKeeper keeper;
  keeper.keep_last = [&](FilmState state) { kept = std::move(state); };
  RenderGoal half;
  half.spp = sample_count / 2;
  static_cast<void>(renderer.render({}, half, &keeper));
  REQUIRE(kept);
  CHECK(kept->film.has_squares);
  const FilmState begun = *kept;
  keeper.begin_with = &begun;
  CHECK(same(whole, renderer.render({}, {}, &keeper)));
  Renderer plain(Device::open("pocl"), lamp_room(), {});
  CHECK_THROWS_WITH(plain.render({}, {}, &keeper), Catch::Contains("of another picture"));
}

TEST_CASE("squares beyond a float cost neither picture nor told error") {
  require_pocl();
  Scene scene = lamp_room();
  for (Shape& shape : scene.shapes)
    if (shape.radiance) shape.radiance = Rgb{1e20, 1e20, 1e20};
  const RenderResult result = Renderer(Device::open("pocl"), scene, with_moments()).render();
  CHECK(result.stats.unusual.not_finite() == 0);
  CHECK(result.error);
  CHECK(*std::max_element(result.named_aov.data.begin(), result.named_aov.data.end()) > 1e37F);
}

}  // namespace strahl::test
