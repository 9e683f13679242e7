// SPDX-License-Identifier: MIT
// Checks every entry of cl/textures/textures.def in every tier: values stay within the texture's colours; a footprint
// of zero is a point sample; a wide one is the mean of point samples over it, an infinite one that over the whole
// pattern; no footprint changes the mean. A new entry needs one row in `texture_rows`.
#include <functional>
#include <limits>

#include "physics/rows.h"
#include "physics/transport_scenes.h"

using namespace strahl;
using namespace strahl::test;

namespace {

struct TextureRow {
  std::string entry;  ///< Of textures.def.
  Texture texture;
  Triad least, most;  ///< Of its colours.
  Triad mean;         ///< Over the whole pattern.
  double period;      ///< In u and in v; a texture without one: so long that its mean is the pattern's.
  /// The point sample in double precision; none where there is no formula.
  std::function<Triad(double u, double v)> value;
  /// Footprints that are filtered, and by a box along u and v; none: only the mean is known.
  std::vector<double> boxes;
};

Triad checker(double u, double v, const Triad& same, const Triad& other) {
  const auto is_first = [](double x) { return x - std::floor(x) <= 0.5; };
  return is_first(u) == is_first(v) ? same : other;
}

Texture texture_of(const Checkerboard& board) {
  Texture texture;
  texture.pattern = board;
  return texture;
}

std::vector<TextureRow> texture_rows() {
  const Triad a{0.75, 0.25, 1}, b{0.125, 0.5, 0}, least{0.125, 0.25, 0}, most{0.75, 0.5, 1}, mean{0.4375, 0.375, 0.5};
  const Rgb colour{0.75, 0.25, 1}, other{0.125, 0.5, 0};
  return {{"checkerboard",
           texture_of({colour, other, {1, 0, 0, 0, 1, 0}}),
           least,
           most,
           mean,
           1,
           [=](double u, double v) { return checker(u, v, a, b); },
           {0.375, 0.75, 2.5}},
          {"checkerboard",
           texture_of({colour, other, {0, 2, 0.125, -1, 0, 0.0625}}),
           least,
           most,
           mean,
           1,
           [=](double u, double v) { return checker(2 * v + 0.125, 0.0625 - u, a, b); },
           {0.375, 0.75, 2.5}},
          // Turned: its filter is as wide as the turned box reaches.
          {"checkerboard",
           texture_of({colour, other, {1, 2, 0.125, -2, 1, 0}}),
           least,
           most,
           mean,
           1,
           [=](double u, double v) { return checker(u + 2 * v + 0.125, v - 2 * u, a, b); },
           {}}};
}

const std::vector<std::string> texture_entries = {
#define TEXTURE(name) #name,
#include "../../cl/textures/textures.def"
#undef TEXTURE
};

/// On a square of side 1: u and v change as lengths do.
Scene scene_of_texture(const TextureRow& row) {
  Scene scene = empty_scene();
  scene.textures.push_back(row.texture);
  scene.materials.front().bsdf = Diffuse{{{}, 0}};
  scene.shapes.emplace_back().geometry = Rectangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  return scene;
}

/// visit(tier, row, value): value(u, v, footprint) of the texture.
template <class Visit>
void for_each_texture(Visit visit) {
  for (const TextureRow& row : texture_rows())
    for (const TransportTier& tier : transport_tiers()) {
      if (tier.lanes > 1) continue;  // Textures are asked point by point.
      const TierScene scene(scene_of_texture(row), tier);
      INFO(tier.name << ", " << row.entry);
      visit(tier, row, [&](double u, double v, double footprint) {
        return tier.texture(scene.buffers(), 0, {{u, v, footprint}}).front();
      });
    }
}

/// Of point samples over a box about (u, v), on a grid that no edge of a square of 1/16 or more meets.
template <class Value>
Triad mean_over(const Value& value, double u, double v, double width) {
  constexpr int side = 64;
  Triad sum{};
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const Triad one = value(u + width * ((i + 0.5) / side - 0.5), v + width * ((j + 0.5) / side - 0.5));
      for (std::size_t k = 0; k < 3; ++k) sum[k] += one[k] / (side * side);
    }
  return sum;
}

TEST_CASE("every texture has a row") {
  hold_rows("textures.def", texture_entries, texture_rows(), [](const TextureRow& row) {
    const TierScene scene(scene_of_texture(row), true, 1);
    return scene.index(scene.index(layout::HEADER_TEXTURES) + layout::TEXTURE_KIND);
  });
}

TEST_CASE("textures stay within their colours, whatever the footprint, and without one are point samples") {
  for_each_texture([&](const TransportTier& tier, const TextureRow& row, const auto& value) {
    std::mt19937_64 engine(5);
    const double infinite = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 500; ++i) {
      const double u = std::ldexp(static_cast<double>(engine() % 8192) + 0.5, -10) - 4;
      const double v = std::ldexp(static_cast<double>(engine() % 8192) + 0.5, -10) - 4;
      const Triad point = value(u, v, 0);
      if (row.value) CHECK(point == row.value(u, v));
      for (const double footprint : {0.0, 1e-30, 0.01, 0.3, 1.0, 7.3, 1e20, infinite}) {
        const Triad found = value(u, v, footprint);
        for (std::size_t k = 0; k < 3; ++k) {
          // A filtered mean is a difference of integrals, divided by the width; its rounding may lead past the colours
          // by this much.
          CHECK(found[k] >= row.least[k] - 32 * roundoff(tier));
          CHECK(found[k] <= row.most[k] + 32 * roundoff(tier));
        }
      }
    }
  });
}

TEST_CASE("a wide footprint is the mean of point samples over it, an infinite one that of the whole pattern") {
  for_each_texture([&](const TransportTier&, const TextureRow& row, const auto& value) {
    const auto point = [&](double u, double v) { return value(u, v, 0); };
    for (const double width : row.boxes)
      for (const auto& [u, v] : {std::pair{0.3, 0.2}, std::pair{0.5, 0.9}, std::pair{-3.1, 7.7}}) {
        INFO("box of " << width << " about " << u << ", " << v);
        const Triad found = value(u, v, width), expected = mean_over(point, u, v, width);
        // A row of the grid more or less, along each axis.
        for (std::size_t k = 0; k < 3; ++k)
          CHECK(found[k] == Approx(expected[k]).margin((row.most[k] - row.least[k]) * 3.0 / 64));
      }
    for (const double width : {1e20, std::numeric_limits<double>::infinity()}) {
      const Triad found = value(0.3, 0.2, width);
      INFO("footprint " << width);
      for (std::size_t k = 0; k < 3; ++k) CHECK(found[k] == Approx(row.mean[k]).epsilon(1e-6));
    }
  });
}

TEST_CASE("no footprint changes the mean over the whole pattern") {
  for_each_texture([&](const TransportTier&, const TextureRow& row, const auto& value) {
    for (const double footprint : {0.0, 0.1, 0.3, 0.7, 1.9}) {
      INFO("footprint " << footprint);
      const Triad mean =
          mean_over([&](double u, double v) { return value(u, v, footprint); }, 0.013, 0.007, row.period);
      for (std::size_t k = 0; k < 3; ++k)
        CHECK(mean[k] == Approx(row.mean[k]).margin((row.most[k] - row.least[k]) / 32));
    }
  });
}

}  // namespace
