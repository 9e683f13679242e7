// SPDX-License-Identifier: MIT
// --texture-lod is in a program where it is asked for and there is a bitmap to filter, and only there.
#include <catch2/catch.hpp>

#include "program/features.h"

using namespace strahl;

TEST_CASE("TEXTURE_LOD: asked for, and a bitmap to filter") {
  Scene scene;
  scene.shapes.emplace_back().geometry = Sphere{};
  RenderSettings settings;
  settings.texture_lod = true;
  CHECK_FALSE(features_of(scene, settings).flag("TEXTURE_LOD"));
  Bitmap bitmap;
  bitmap.texels = std::make_shared<const Texels>(texels_of_floats(1, 1, 1, {0.5F}));
  scene.textures.emplace_back().pattern = bitmap;
  scene.materials.front().bsdf = Diffuse{{{1, 1, 1}, 0}};
  CHECK(features_of(scene, settings).flag("TEXTURE_LOD"));
  CHECK_FALSE(features_of(scene, {}).flag("TEXTURE_LOD"));
  RenderSettings generic;
  generic.generic = true;
  CHECK_FALSE(features_of(scene, generic).flag("TEXTURE_LOD"));
}
