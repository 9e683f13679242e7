// SPDX-License-Identifier: MIT
// The AOV numeric_error tells a tier that is right from one that is not. 4 s.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "render/pictures.h"
#include "study/transformed.h"

namespace strahl::test {
namespace {

struct Errors {
  std::vector<float> finite;  ///< Ascending.
  std::size_t wrong = 0;      ///< Hit for miss or miss for hit.
};

const Scene& planet() {
  static const Scene scene = small_scene(scene_folder / "accuracy/planet-horizon.xml", 32, 24, 1);
  return scene;
}

Errors errors(const Scene& scene, Precision precision) {
  require_pocl();
  RenderSettings settings;
  settings.precision = precision;
  settings.aovs = {Aov::numeric_error};
  const Image image = render("pocl", scene, settings).aov;
  REQUIRE(image.channels == std::vector<std::string>{"numeric_error.ULP"});
  REQUIRE(image.data.size() == 32 * 24);
  Errors errors;
  for (const float ulps : image.data) {
    REQUIRE(ulps >= 0);
    if (std::isinf(ulps))
      ++errors.wrong;
    else
      errors.finite.push_back(ulps);
  }
  std::sort(errors.finite.begin(), errors.finite.end());
  return errors;
}

TEST_CASE("a planet below the eye") {
  const Errors robust = errors(planet(), Precision::robust);
  CHECK(robust.wrong == 0);
  CHECK(robust.finite.back() <= 1);
  CHECK(robust.finite.back() > 0.1F);  // It is measured: t was rounded once.
  const Errors fast = errors(planet(), Precision::fast);
  CHECK(fast.finite[fast.finite.size() / 2] > 1000);
}

TEST_CASE("double agrees with double, in the camera's frame and in the world's") {
  const Errors same = errors(translated(scaled(planet(), 3), {1e3, 2e3, 3e3}), Precision::fp64);
  CHECK(same.wrong == 0);
  CHECK(same.finite.back() < 0.01F);
}

TEST_CASE("what is not seen where it stands is infinitely wrong") {
  Scene pebble = planet();
  pebble.shapes.resize(1);
  pebble.shapes[0].geometry = Sphere{{0, 0, -1e4}, 1e-3};
  pebble.camera.world_from_camera.m = {{{-1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, -1, 0}}};
  pebble.camera.fov_degrees = 1.4e-5;
  CHECK(errors(pebble, Precision::fast).wrong > 32 * 24 / 4);
  CHECK(errors(pebble, Precision::robust).wrong == 0);
}

}  // namespace
}  // namespace strahl::test
