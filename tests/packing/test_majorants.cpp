// SPDX-License-Identifier: MIT
// No place of a medium that varies is denser than its cell says, however its box is turned and goes on beyond it.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "packing/majorants.h"
#include "scene/model/transforms.h"

namespace strahl::test {
namespace {

int wrapped(int texel, int size, TextureWrap wrap) {
  while (texel < 0 || texel >= size) {
    if (wrap == TextureWrap::clamp) return texel < 0 ? 0 : size - 1;
    if (wrap == TextureWrap::repeat) texel += texel < 0 ? size : -size;
    if (wrap == TextureWrap::mirror) texel = texel < 0 ? -1 - texel : 2 * size - 1 - texel;
  }
  return texel;
}

/// The trilinear mean at a place of the cube's frame.
double value_at(const Volume& volume, const Vec3& p) {
  const VolumeGrid& grid = *volume.grid;
  const int w = grid.texels.width, h = grid.height, d = grid.depth;
  const double x = p.x * w - 0.5, y = p.y * h - 0.5, z = p.z * d - 0.5;
  const auto weight = [](double at, int side) { return side ? at - std::floor(at) : 1 - (at - std::floor(at)); };
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const int i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
    const int tx = wrapped(static_cast<int>(std::floor(x)) + i, w, volume.wrap);
    const int ty = wrapped(static_cast<int>(std::floor(y)) + j, h, volume.wrap);
    const int tz = wrapped(static_cast<int>(std::floor(z)) + k, d, volume.wrap);
    sum += weight(x, i) * weight(y, j) * weight(z, k) *
           static_cast<double>(grid.texels.reals[static_cast<std::size_t>((tz * h + ty) * w + tx)]);
  }
  return volume.value.r * sum;
}

Vec3 in_frame(const std::vector<double>& reals, const Vec3& p) {
  const Vec3 q{p.x - reals[0], p.y - reals[1], p.z - reals[2]};
  return {dot({reals[3], reals[4], reals[5]}, q), dot({reals[6], reals[7], reals[8]}, q),
          dot({reals[9], reals[10], reals[11]}, q)};
}

/// Few of its texels are dense.
Volume random_volume(std::mt19937& random, int round) {
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<float> values(static_cast<std::size_t>(21 * 9 * 13));
  for (float& v : values) v = static_cast<float>(std::pow(unit(random), 8) + 1e-3 * unit(random));
  Volume volume = Rgb{3, 3, 3};
  volume.grid = std::make_shared<const VolumeGrid>(grid_of_floats(21, 9, 13, 1, values));
  volume.wrap = static_cast<TextureWrap>(round % 3);
  const Transform turned = rotation({unit(random), unit(random) + 0.1, unit(random)}, 360 * unit(random));
  const Transform placed{{{{2, 0, 0, 5}, {0, 0.7, 0, -3}, {0, 0, 1.3, 2}}}};
  volume.world_from_cube = round % 2 == 0 ? placed : placed * turned;
  return volume;
}

int cell_along(double from_middle, int count) {
  const double place = from_middle + 0.5 * count;
  REQUIRE(place > -1e-9);
  REQUIRE(place < count + 1e-9);
  return std::min(std::max(static_cast<int>(place), 0), count - 1);
}

TEST_CASE("no place within the box is denser than its cell") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0, 1);
  const UploadFrame frame{{1, 2, 3}, 0.5};
  for (int round = 0; round < 60; ++round) {
    const Volume volume = random_volume(random, round);
    REQUIRE(volume.grid->texels.format == TexelFormat::real);
    const Transform cube_from_world = volume.world_from_cube.inverse();
    const Majorants majorants = majorants_of(volume, frame);
    const auto [width, height, depth] = majorants.size;
    REQUIRE(majorants.most.size() == static_cast<std::size_t>(width * height * depth));
    const double* low = &majorants.reals[12];
    const double* high = &majorants.reals[15];
    int dense = 0;
    for (int i = 0; i < 2000; ++i) {
      const Vec3 p{low[0] + unit(random) * (high[0] - low[0]), low[1] + unit(random) * (high[1] - low[1]),
                   low[2] + unit(random) * (high[2] - low[2])};
      const Vec3 cell = in_frame(majorants.reals, p);
      const int at =
          (cell_along(cell.z, depth) * height + cell_along(cell.y, height)) * width + cell_along(cell.x, width);
      const double most = static_cast<double>(majorants.most[static_cast<std::size_t>(at)]);
      const Vec3 world{p.x / frame.scale + 1, p.y / frame.scale + 2, p.z / frame.scale + 3};
      const double value = value_at(volume, cube_from_world.point(world)) / frame.scale;
      REQUIRE(value <= most * (1 + 1e-12));
      dense += value > 0.5 * most ? 1 : 0;
    }
    // Bounds that are far too large would hold as well.
    CHECK(dense > 0);
  }
}

TEST_CASE("a thin turned box has no more cells than others") {
  for (const TextureWrap wrap : {TextureWrap::clamp, TextureWrap::repeat, TextureWrap::mirror}) {
    Volume volume = Rgb{1, 1, 1};
    volume.grid = std::make_shared<const VolumeGrid>(
        grid_of_floats(64, 64, 64, 1, std::vector<float>(static_cast<std::size_t>(64 * 64 * 64), 0.7F)));
    volume.wrap = wrap;
    const Transform flat{{{{1e4, 0, 0, 0}, {0, 1e4, 0, 0}, {0, 0, 1e-4, 0}}}};
    volume.world_from_cube = rotation({1, 2, 3}, 40) * flat;
    const Majorants majorants = majorants_of(volume, UploadFrame{{0, 0, 0}, 1});
    CHECK(majorants.most.size() <= static_cast<std::size_t>(128 * 128 * 128));
    for (const float most : majorants.most) REQUIRE(most == Approx(0.7F));
  }
}

TEST_CASE("no way within a cell is longer than the box") {
  Volume volume = Rgb{1, 1, 1};
  volume.grid = std::make_shared<const VolumeGrid>(grid_of_floats(1, 1, 1, 1, {1}));
  volume.world_from_cube = Transform{{{{3, 0, 0, 0}, {0, 5, 0, 0}, {0, 0, 2, 0}}}};
  CHECK(majorants_of(volume, UploadFrame{{0, 0, 0}, 0.5}).cell == Approx(2.5));
}

}  // namespace
}  // namespace strahl::test
