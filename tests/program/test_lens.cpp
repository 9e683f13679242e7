// SPDX-License-Identifier: MIT
// The feature THIN_LENS: of a camera with a lens, unless every sample goes through its middle.
#include <catch2/catch.hpp>

#include "program/features.h"

using namespace strahl;

TEST_CASE("a lens is called for by a camera that has one") {
  Scene scene;
  scene.shapes.emplace_back().geometry = Sphere{};
  const auto has_lens = [&] { return features_of(scene, {}).flag("THIN_LENS"); };
  CHECK_FALSE(has_lens());
  scene.camera.aperture_radius = 0.1;
  CHECK(has_lens());
  scene.sampler.kind = SamplerKind::centre;
  CHECK_FALSE(has_lens());
}
