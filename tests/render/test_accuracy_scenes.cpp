// SPDX-License-Identifier: MIT
// The hard scenes of scenes/accuracy look in the robust tier as they do in double, and in fast they do not: RMSE of the
// picture, whose values are of the order of 1.
#include <catch2/catch.hpp>

#include "image/metrics.h"
#include "render/pictures.h"

namespace strahl::test {
namespace {

double rmse_against_double(const Scene& scene, const Image& reference, Precision precision, bool paths_in_lanes) {
  RenderSettings settings;
  settings.precision = precision;
  settings.generic = precision == Precision::robust && paths_in_lanes;  // Which other tests have built.
  settings.paths_in_lanes = paths_in_lanes;
  return compare_images(render("pocl", scene, settings).color, reference, Metric::rmse);
}

void hold(const std::string& name, bool in_lanes) {
  require_pocl();
  const Scene scene = small_scene(scene_folder / ("accuracy/" + name + ".xml"), 64, 64, 4);
  RenderSettings in_double;
  in_double.precision = Precision::fp64;
  const Image reference = render("pocl", scene, in_double).color;
  CHECK(lit_pixels(reference) > 64 * 64 / 8);
  CHECK(rmse_against_double(scene, reference, Precision::robust, in_lanes) < 1e-3);
  CHECK(rmse_against_double(scene, reference, Precision::fast, in_lanes) > 5e-3);
}

TEST_CASE("a pebble far off") { hold("far-pebble", true); }
TEST_CASE("the horizon of a planet") { hold("planet-horizon", true); }
TEST_CASE("both, paths one by one", "[slow]") {
  hold("far-pebble", false);
  hold("planet-horizon", false);
}

}  // namespace
}  // namespace strahl::test
