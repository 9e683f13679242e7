// SPDX-License-Identifier: MIT
// Materials that have a lobe which they hardly draw, and what they mean for a sky.
#include <catch2/catch.hpp>

#include "kinds/lights.h"
#include "kinds/principled_lobes.h"

namespace strahl::test {
namespace {

using kinds::draws_all_lobes;

constexpr Rgb black{0, 0, 0}, white{1, 1, 1};

TEST_CASE("a principled draws all of its lobes but where a rate is 0, or sheen lies on glass alone") {
  CHECK(draws_all_lobes(Principled{}));
  Principled bsdf;
  bsdf.clearcoat_sampling_rate = 0;
  CHECK(draws_all_lobes(bsdf));
  bsdf.clearcoat = {white};
  CHECK_FALSE(draws_all_lobes(bsdf));
  bsdf = {};
  bsdf.main_specular_sampling_rate = 0;
  CHECK_FALSE(draws_all_lobes(bsdf));
  bsdf = {};
  bsdf.diffuse_reflectance_sampling_rate = 0;
  CHECK_FALSE(draws_all_lobes(bsdf));
  bsdf.metallic = {white};
  CHECK(draws_all_lobes(bsdf));
  bsdf = {};
  bsdf.spec_trans = {white};
  CHECK(draws_all_lobes(bsdf));
  bsdf.sheen = {white};
  CHECK_FALSE(draws_all_lobes(bsdf));
  bsdf.spec_trans = {{0.5, 0.5, 0.5}};
  CHECK(draws_all_lobes(bsdf));
  bsdf.spec_trans.texture = 0;
  CHECK_FALSE(draws_all_lobes(bsdf));
  bsdf.metallic = {white};
  CHECK(draws_all_lobes(bsdf));
}

TEST_CASE("a principledthin draws all of its lobes but where a rate is 0") {
  CHECK(draws_all_lobes(PrincipledThin{}));
  PrincipledThin bsdf;
  bsdf.diffuse_transmittance_sampling_rate = 0;
  CHECK(draws_all_lobes(bsdf));
  bsdf.diff_trans = {white};
  CHECK_FALSE(draws_all_lobes(bsdf));
  bsdf.spec_trans = {white};
  CHECK(draws_all_lobes(bsdf));
  bsdf.specular_transmittance_sampling_rate = 0;
  CHECK_FALSE(draws_all_lobes(bsdf));
  bsdf.spec_trans = {black};
  CHECK_FALSE(draws_all_lobes(bsdf));
  bsdf.diff_trans = {black};
  CHECK(draws_all_lobes(bsdf));
  bsdf.diffuse_reflectance_sampling_rate = 0;
  CHECK_FALSE(draws_all_lobes(bsdf));
  bsdf.diff_trans = {{2, 2, 2}};
  CHECK(draws_all_lobes(PrincipledThin{.diff_trans = {{2, 2, 2}}, .diffuse_reflectance_sampling_rate = 0}));
}

TEST_CASE("a constant sky is drawn where a material hardly draws a lobe") {
  Scene scene;
  scene.integrator.name = "path";
  scene.materials.resize(2);
  const Light sky{{}, ConstantLight{}, {}};
  CHECK_FALSE(kinds::is_drawn(sky, scene));
  Principled bsdf;
  bsdf.diffuse_reflectance_sampling_rate = 0;
  scene.materials[1].bsdf = bsdf;
  CHECK(kinds::is_drawn(sky, scene));
}

}  // namespace
}  // namespace strahl::test
