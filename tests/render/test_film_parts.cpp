// SPDX-License-Identifier: MIT
// How threads share a film: all of its rows once, in whole bands; and that neither they nor parts decide bits.
#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "render/error_law.h"
#include "render/film_parts.h"
#include "render/pictures.h"

namespace strahl::test {
namespace {

constexpr std::size_t pixel_bytes = 192;

TEST_CASE("parts are all rows once, in whole bands") {
  for (const int height : {1, 3, 4, 5, 44, 256, 257, 1080, 4321})
    for (const int width : {1, 256, 1920, 100000})
      for (const unsigned threads : {1U, 2U, 3U, 8U}) {
        INFO(width << " x " << height << ", " << threads << " threads");
        const std::vector<Rows> parts = film_parts(height, static_cast<std::size_t>(width) * pixel_bytes, threads);
        int row = 0;
        for (const Rows& part : parts) {
          CHECK(part.first == row);
          CHECK(part.first % rows_per_band == 0);
          CHECK(part.count > 0);
          row += part.count;
        }
        CHECK(row == height);
      }
}

TEST_CASE("parts are as many for each thread, and as high") {
  for (const unsigned threads : {2U, 3U, 8U}) {
    const std::vector<Rows> parts = film_parts(1080, 1920 * pixel_bytes, threads);
    CHECK(parts.size() % threads == 0);
    const auto [low, high] =
        std::minmax_element(parts.begin(), parts.end(), [](const Rows& a, const Rows& b) { return a.count < b.count; });
    CHECK(high->count - low->count <= rows_per_band);
    CHECK(low->count >= 8);
  }
  CHECK(film_parts(32, 32 * pixel_bytes, 8).size() == 1);
}

/// All of a picture's rows by one render, whose parts are for several threads, and by several renders of one part each.
TEST_CASE("a picture of several parts is what its strips are") {
  require_pocl();
  constexpr int width = 113, height = 131, strip = 31;
  RenderSettings settings;
  settings.error_map = true;
  Renderer renderer(Device::open("pocl"),
                    small_scene(scene_folder / "cornell/cornell-box.xml", width, height, layout::FILM_SUBSUMS),
                    settings);
  REQUIRE(film_parts(height, width * pixel_bytes, 2).size() > 1);
  const RenderResult whole = renderer.render();
  REQUIRE(whole.error);
  for (int row = 0; row < height; row += strip) {
    RenderGoal goal;
    goal.rows = Rows{row, std::min(strip, height - row)};
    const RenderResult part = renderer.render({}, goal);
    const auto first = static_cast<std::ptrdiff_t>(row) * width * 3;
    const std::size_t values = static_cast<std::size_t>(goal.rows->count) * width * 3;
    REQUIRE(part.color.data.size() == values);
    REQUIRE(part.standard_error.data.size() == values);
    CHECK(std::equal(part.color.data.begin(), part.color.data.end(), whole.color.data.begin() + first));
    CHECK(std::equal(part.standard_error.data.begin(), part.standard_error.data.end(),
                     whole.standard_error.data.begin() + first));
  }
}

}  // namespace
}  // namespace strahl::test
