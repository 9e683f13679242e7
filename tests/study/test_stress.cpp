// SPDX-License-Identifier: MIT
// strahl stress in small: no unit and no place costs the robust tier anything, and the textbook's tier pays. 4 s.
#include <catch2/catch.hpp>

#include "render/pictures.h"
#include "study/stress.h"

namespace strahl::test {
namespace {

TEST_CASE("every stress, every tier") {
  require_pocl_and_rusticl();
  const Device device = Device::open("pocl", {true});
  Scene scene = small_scene(scene_folder / "lecture/lit.xml", 40, 30, 1);
  int calls = 0, last = 0;
  const StressStudy study = study_stress(device, scene, [&](int done, int total) {
    ++calls;
    last = done;
    CHECK(total == 32);
  });
  CHECK(calls == 32);
  CHECK(last == 32);
  REQUIRE(study.reference == Precision::fp64);
  REQUIRE(study.tiers == std::vector{Precision::fast, Precision::stable, Precision::robust, Precision::fp64});

  const auto rmse = [&](Precision precision, double scale, double offset) {
    for (std::size_t i = 0; i < study.tiers.size(); ++i)
      for (std::size_t k = 0; k < all_stresses().size(); ++k)
        if (study.tiers[i] == precision && all_stresses()[k].scale == scale && all_stresses()[k].offset == offset)
          return study.cells.at(i).at(k).rmse;
    FAIL("no such cell");
    return 0.0;
  };
  CHECK(rmse(Precision::fp64, 1, 0) == 0);
  for (const Stress& stress : all_stresses()) {
    INFO(stress.text());
    CHECK(rmse(Precision::fp64, stress.scale, stress.offset) < 0.01);
    CHECK(rmse(Precision::robust, stress.scale, stress.offset) < 0.01);
  }
  CHECK(rmse(Precision::robust, 1, 0) > 0);  // Another picture, not the reference once more.
  CHECK(rmse(Precision::fast, 1, 0) < 0.03);
  CHECK(rmse(Precision::fast, 1, 1e7) > 0.1);
  CHECK(rmse(Precision::fast, 1e-6, 0) > 0.03);

  const Image sheet = stress_sheet(study);
  CHECK(sheet.width > 8 * 40);
  CHECK(sheet.height > 4 * 30);
}

}  // namespace
}  // namespace strahl::test
