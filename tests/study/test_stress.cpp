// SPDX-License-Identifier: MIT
// strahl stress in small: no unit, no place, no light, no far object and no lamp's size costs the robust tier anything,
// and the textbook's tier pays. 20 s.
#include <catch2/catch.hpp>

#include "image/metrics.h"
#include "render/pictures.h"
#include "study/stress.h"
#include "study/transformed.h"

namespace strahl::test {
namespace {

TEST_CASE("every stress, every tier") {
  require_pocl();
  const Device device = Device::open("pocl", {true});
  Scene scene = small_scene(scene_folder / "lecture/lit.xml", 40, 30, 1);
  int calls = 0, last = 0;
  const StressStudy study = study_stress(device, scene, [&](int done, int total) {
    ++calls;
    last = done;
    CHECK(total == 48);
  });
  CHECK(calls == 48);
  CHECK(last == 48);
  REQUIRE(study.reference == Precision::fp64);
  REQUIRE(study.tiers == std::vector{Precision::fast, Precision::stable, Precision::robust, Precision::fp64});

  const auto cell = [&](Precision precision, const std::string& stress) {
    for (std::size_t i = 0; i < study.tiers.size(); ++i)
      for (std::size_t k = 0; k < all_stresses().size(); ++k)
        if (study.tiers[i] == precision && all_stresses()[k].text() == stress) return study.cells.at(i).at(k);
    FAIL("no such cell: " << stress);
    return StressCell{};
  };
  const auto rmse = [&](Precision precision, const std::string& stress) { return cell(precision, stress).rmse; };
  CHECK(rmse(Precision::fp64, "as it is") == 0);
  for (const Stress& stress : all_stresses()) {
    INFO(stress.text());
    CHECK(rmse(Precision::fp64, stress.text()) < 1e-7);
    CHECK(rmse(Precision::robust, stress.text()) < 1e-5);
    CHECK(rmse(Precision::stable, stress.text()) < 1e-5);
  }
  // Held against the same lamp.
  for (const char* lamp : {"far 1e+07", "lamp 1e-07"}) CHECK(rmse(Precision::fp64, lamp) == 0);
  CHECK(rmse(Precision::robust, "as it is") > 0);  // Another picture, not the reference once more.
  CHECK(rmse(Precision::fast, "as it is") < 0.03);
  CHECK(rmse(Precision::fast, "offset 1e+07") > 0.1);
  CHECK(rmse(Precision::fast, "scale 1e-06") > 0.03);
  // The lamp lights something.
  CHECK(compare_images(cell(Precision::fp64, "lamp 1e-07").picture, cell(Precision::fp64, "as it is").picture,
                       Metric::rmse) > 0.05);

  const Image sheet = stress_sheet(study);
  CHECK(sheet.width > 12 * 40);
  CHECK(sheet.height > 4 * 30);
}

/// A scene whose numbers have lengths in them shows the same picture in any unit, in any place, and by more light.
void hold_in_double(const std::string& what, const Scene& scene) {
  const RenderSettings settings = generic_settings(Precision::fp64);
  const Image first = render("pocl", scene, settings).color;
  const auto hold = [&](const std::string& how, const Scene& other, double unit) {
    CAPTURE(what, how);
    Image picture = render("pocl", other, settings).color;
    for (float& value : picture.data) value = static_cast<float>(value / unit);
    CHECK(compare_images(picture, first, Metric::rmse) < 0.02);
  };
  const bool is_length = scene.integrator.name == "depth";
  hold("scale 1e-6", scaled(scene, 1e-6), is_length ? 1e-6 : 1);
  hold("offset 1e5", translated(scene, {1e5, 1e5, 1e5}), 1);
  if (!is_length) hold("light 1e10", brightened(scene, 1e10), 1e10);
}

TEST_CASE("media, heights and distances have units, too", "[slow]") {
  require_pocl();
  hold_in_double("fog", small_scene(scene_folder / "media/fog.xml", 16, 12, 1));
  hold_in_double("a candle", small_scene(scene_folder / "media/candle.xml", 16, 12, 1));
  hold_in_double("heights", small_scene(scene_folder / "materials/bumpmap.xml", 16, 12, 1));
  Scene depth = small_scene(scene_folder / "lecture/lit.xml", 16, 12, 1);
  depth.integrator.name = "depth";
  hold_in_double("depth", depth);
}

}  // namespace
}  // namespace strahl::test
