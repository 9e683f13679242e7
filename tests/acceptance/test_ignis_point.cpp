// SPDX-License-Identifier: MIT
// A point light over a diffuse square against 4096 samples a pixel by Ignis (../shared/data/ignis): the scene file as
// it is, but for the number of samples. Only the sampling noise of a smooth shade within a pixel is left; the seed
// fixes it.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "acceptance/pictures.h"
#include "image/image_io.h"
#include "support/needs.h"

namespace strahl::test {
namespace {

const Needs needs(STRAHL_SOURCE_DIR "/../shared/data/ignis");

bool is_lit(const Image& image, int x, int y) { return image.at(x, y, 0) + image.at(x, y, 1) + image.at(x, y, 2) > 0; }

/// Lit and unlit pixels meet in the 3 x 3 neighbourhood.
bool is_edge(const Image& image, int x, int y) {
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, image.height - 1); ++v)
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, image.width - 1); ++u)
      if (is_lit(image, u, v) != is_lit(image, x, y)) return true;
  return false;
}

TEST_CASE("point light over a square: Ignis's picture") {
  LoadedScene loaded = load_scene(shared_data + "ignis/evaluation/point.xml", {{{"spp", "64"}}, false});
  REQUIRE(loaded.warnings.empty());
  const Image ours = picture(loaded.scene).color;
  const Image reference = read_image(shared_data + "ignis/evaluation/references/ref-point-4096.exr");
  REQUIRE(ours.width == reference.width);
  REQUIRE(ours.height == reference.height);
  REQUIRE(reference.channels == std::vector<std::string>{"R", "G", "B"});

  int inner = 0, differ = 0;
  std::vector<double> relative;
  for (int y = 0; y < ours.height; ++y)
    for (int x = 0; x < ours.width; ++x) {
      if (is_edge(reference, x, y)) continue;
      ++inner;
      if (is_lit(ours, x, y) != is_lit(reference, x, y)) ++differ;
      if (!is_lit(ours, x, y) || !is_lit(reference, x, y)) continue;
      for (int c = 0; c < 3; ++c)
        relative.push_back(std::fabs(double{ours.at(x, y, c)} - reference.at(x, y, c)) / reference.at(x, y, c));
    }
  REQUIRE(inner > 60000);
  CHECK(differ <= inner / 1000);
  REQUIRE(relative.size() > 3 * 13000);
  const auto middle = relative.begin() + static_cast<std::ptrdiff_t>(relative.size() / 2);
  std::nth_element(relative.begin(), middle, relative.end());
  INFO("median relative difference " << *middle);
  CHECK(*middle < 5e-4);
}

}  // namespace
}  // namespace strahl::test
