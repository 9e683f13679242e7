// SPDX-License-Identifier: MIT
// Pictures whose samples count in several pixels: even light stays even, a crop has the bits of the whole, whatever
// made them, and the noise is what the filter leaves of it. What edges become: test_filter.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "render/stage.h"
#include "scene/model/build.h"

namespace strahl::test {
namespace {

Image picture(const Scene& scene, const std::set<std::string>& disabled = {}) {
  require_pocl_and_rusticl();
  return stage_picture(scene, Precision::robust, disabled).color;
}

/// A floor under a lamp that is far larger, by samples that know nothing of each other: noise and hardly an edge.
Scene noisy_floor(std::uint32_t seed) {
  Scene scene = stage({floor_plane()}, diffuse({0.5, 0.5, 0.5}));
  add(scene, emitting(Rectangle{{-20, -20, 6}, {0, 40, 0}, {40, 0, 0}}, {1, 1, 1}));
  scene.integrator.name = "direct";
  scene.sampler.kind = SamplerKind::independent;
  scene.sampler.sample_count = 4;
  scene.sampler.seed = seed;
  return scene;
}

double variance_of(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.data.size(); ++i) sum += std::pow(static_cast<double>(a.data[i]) - b.data[i], 2) / 2;
  return sum / static_cast<double>(a.data.size());
}

}  // namespace

TEST_CASE("of equal samples the mean is what each of them is") {
  Scene scene = stage({});
  add(scene, emitting(Rectangle{{-9, -9, 0}, {18, 0, 0}, {0, 18, 0}}, {0.7, 3e-9, 2e7}));
  scene.integrator.name = "emission";
  scene.sampler.kind = SamplerKind::sobol;
  for (const int samples : {1, 4, 33}) {
    scene.sampler.sample_count = samples;
    const Image image = picture(scene);
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        CAPTURE(samples, x, y);
        CHECK(image.at(x, y, 0) == Approx(0.7F).epsilon(3e-7));
        CHECK(image.at(x, y, 1) == Approx(3e-9F).epsilon(3e-7));
        CHECK(image.at(x, y, 2) == Approx(2e7F).epsilon(3e-7));
      }
  }
}

TEST_CASE("a crop's pixels are made of samples around it, as in the whole picture") {
  Scene scene = noisy_floor(3);
  const Image whole = picture(scene);
  for (const Window& window : {Window{7, 5, 8, 6}, {0, 0, 3, stage_size}, {20, 30, stage_size, 48}}) {
    scene.film.crop = window;
    const Image part = picture(scene);
    for (int y = 0; y < part.height; ++y)
      for (int x = 0; x < part.width; ++x)
        for (int c = 0; c < 3; ++c) CHECK(part.at(x, y, c) == whole.at(window.x0 + x, window.y0 + y, c));
  }
}

TEST_CASE("shared samples have the same bits in any passes, lanes and groups") {
  const Scene scene = noisy_floor(5);
  const Image expected = picture(scene);
  const auto is_same = [&](RenderSettings settings, const std::function<void(RenderSettings&)>& change) {
    change(settings);
    return render("pocl", scene, settings).color.data == expected.data;
  };
  for (const int passes : {1, 3, 4})
    CHECK(is_same(stage_settings(Precision::robust), [&](RenderSettings& s) { s.passes = passes; }));
  CHECK(is_same(stage_settings(Precision::robust), [](RenderSettings& s) { s.work_group = WorkGroup{3, 5}; }));
  CHECK(is_same({}, [](RenderSettings&) {}));
  CHECK(is_same({}, [](RenderSettings& s) { s.lanes = 8; }));
  CHECK(is_same({}, [](RenderSettings& s) { s.paths_in_lanes = false; }));
}

TEST_CASE("shared samples have the same bits where a device ends loops before their time") {
  const Scene scene = lamp_edge(9);
  RenderSettings watched;
  watched.loop_turns = 65535;
  const Image on_pocl = picture(scene), image = render("llvmpipe", scene, watched).color;
  CHECK((image.data == on_pocl.data));
  CHECK((image.data != picture(scene, without_sharing).data));
}

TEST_CASE("noise is what the filter leaves of it") {
  const double shared = variance_of(picture(noisy_floor(1)), picture(noisy_floor(2)));
  const double alone = variance_of(picture(noisy_floor(1), without_sharing), picture(noisy_floor(2), without_sharing));
  CHECK(shared / alone > 0.28);  // 1 / pi of a gaussian that never ends; quotients of few samples are noisier.
  CHECK(shared / alone < 0.37);
}

}  // namespace strahl::test
