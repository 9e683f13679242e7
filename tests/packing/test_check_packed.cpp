// SPDX-License-Identifier: MIT
// What check_packed says of images and grids at the limits of their sides; physics/test_flipped_indices.cpp flips the
// indices of whole scenes.
#include <catch2/catch.hpp>

#include "packing/check_packed.h"
#include "packing/cl_layout.h"
#include "packing/pack.h"
#include "scene/model/build.h"

using namespace strahl;

namespace {

/// A ball of smoke: a grid of `height` x `depth` texels, one wide.
Scene smoke(int height, int depth) {
  Scene scene;
  add(scene, Sphere{});
  const std::vector<std::uint8_t> codes(static_cast<std::size_t>(height) * static_cast<std::size_t>(depth), 9);
  Medium medium;
  medium.sigma_t = Rgb{1, 1, 1};
  medium.sigma_t.grid = std::make_shared<const VolumeGrid>(
      grid_of_texels(height, depth, texels_of_bytes(1, height * depth, 1, codes.data())));
  scene.media = {medium};
  scene.shapes.front().media = MediumBoundary{0, -1};
  scene.integrator.name = "volpath";
  return scene;
}

/// Where the number `field` of the row of sigma_t's grid is.
std::size_t place_in_grid(const PackedScene<float>& packed, const Features& features, int field) {
  const auto rows = static_cast<int>(features.entries.at("shapes").size()) + (features.flag("INSTANCES") ? 1 : 0);
  const int table = layout::HEADER_INTS + rows * layout::SHAPE_INTS;
  const int medium = packed.index.at(static_cast<std::size_t>(table + layout::MEDIA_ROWS));
  const int volumes = packed.index.at(static_cast<std::size_t>(medium + layout::MEDIUM_VOLUMES));
  return static_cast<std::size_t>(volumes + field);
}

}  // namespace

TEST_CASE("the layers of a grid may have more rows together than an image") {
  const Scene scene = smoke(4097, 4097);
  const Features features = features_of(scene, {});
  PackedScene<float> packed = pack_scene<float>(scene, features, {});
  CHECK(fault_of_packed(packed, scene, features, {}).empty());
  // But no side of it is longer than an image's, nor has it more layers than there are.
  for (const auto& [height, depth] : {std::pair(4097 * 4097, 1), {1, 4097 * 4097}, {4097, 4098}, {0, 1}, {1, -1}}) {
    INFO(height << " x " << depth);
    packed.index.at(place_in_grid(packed, features, layout::VOLUME_HEIGHT)) = height;
    packed.index.at(place_in_grid(packed, features, layout::VOLUME_DEPTH)) = depth;
    CHECK(fault_of_packed(packed, scene, features, {}) == "the size of a volume of medium 0");
  }
}
