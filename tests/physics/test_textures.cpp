// SPDX-License-Identifier: MIT
// Checks every entry of cl/textures/textures.def in every tier: values stay within the texture's colours; a footprint
// of zero is a point sample; where the texture filters, a wide one is the mean of point samples over it, an infinite
// one that over the whole pattern; no footprint changes the mean; every width reads the same bits. A new entry needs
// one row in `texture_rows`.
#include <functional>
#include <limits>
#include <numeric>

#include "physics/bitmap_rows.h"
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
  double period;      ///< In u and in v; a texture without one: so long that its mean is the pattern's; 0: no mean.
  /// The point sample in double precision; none where there is no formula.
  std::function<Triad(double u, double v)> value;
  /// Footprints that are filtered, and by a box along u and v; none: only the mean is known.
  std::vector<double> boxes;
  bool is_filtered = true;  ///< Footprints have an effect.
  double rounding = 0;      ///< Of a point sample, in roundoffs.
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
  std::vector<TextureRow> rows = {{"checkerboard",
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
  // Of the corners of a triangle; its continuation goes from 0 to 1.
  Texture attribute;
  attribute.pattern = AttributeTexture{"vertex_color", 0.5};
  const auto corner = [](double u, double v, double at_a, double at_b, double at_c) {
    return std::clamp(0.5 * (at_a + u * (at_b - at_a) + v * (at_c - at_a)), 0.0, 1.0);
  };
  TextureRow of_mesh{"mesh_attribute", attribute, {0, 0, 0}, {1, 1, 1}, {0.5, 0.5, 0.5}, 0, {}, {}, false, 64};
  of_mesh.value = [=](double u, double v) {
    return Triad{corner(u, v, 0.25, 1, 0.5), corner(u, v, 1, 0, 0.75), corner(u, v, 0.5, 0.5, 2)};
  };
  rows.push_back(of_mesh);
  for (const Bitmap& bitmap : bitmaps()) {
    const TexelDecoder decoded(*bitmap.texels, bitmap.curve);
    TextureRow row{"bitmap",       {}, {1, 1, 1}, {0, 0, 0}, {bitmap.mean.r, bitmap.mean.g, bitmap.mean.b},
                   period(bitmap), {}, {},        false,     16};
    row.texture.pattern = bitmap;
    for (std::size_t n = 0; n < bitmap.texels->count(); ++n)
      for (std::size_t c = 0; c < 3; ++c) {
        row.least[c] = std::min(row.least[c], decoded(n)[c]);
        row.most[c] = std::max(row.most[c], decoded(n)[c]);
      }
    row.value = [=](double u, double v) { return bitmap_value(bitmap, decoded, u, v); };
    rows.push_back(row);
  }
  return rows;
}

const std::vector<std::string> texture_entries = {
#define TEXTURE(name) #name,
#include "../../cl/textures/textures.def"
#undef TEXTURE
};

/// On a square of side 1: u and v change as lengths do.
Scene scene_of_texture(const TextureRow& row) {
  Scene scene = empty_scene();
  scene.sampler.kind = SamplerKind::centre;  // Where checkerboards filter over the whole footprint.
  scene.textures.push_back(row.texture);
  scene.materials.front().bsdf = Diffuse{{{}, 0}};
  scene.shapes.emplace_back().geometry = Rectangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  if (row.entry == "mesh_attribute") {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    mesh.attributes = {{"vertex_color", {{0.25, 1, 0.5}, {1, 0, 0.5}, {0.5, 0.75, 2}}}};
    scene.shapes.back().geometry = mesh;
  }
  return scene;
}

/// visit(tier, row, value): value(u, v, footprint) of the texture.
template <class Visit>
void for_each_texture(Visit visit) {
  for (const TextureRow& row : texture_rows())
    for (const TransportTier& tier : transport_tiers()) {
      if (tier.lanes > 1) continue;  // The same bits, below.
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
      if (row.rounding == 0) CHECK(point == row.value(u, v));
      for (std::size_t k = 0; k < 3; ++k)
        CHECK(point[k] == Approx(row.value(u, v)[k]).epsilon(0).margin(row.rounding * roundoff(tier)));
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
      if (!row.is_filtered) continue;
      const Triad found = value(0.3, 0.2, width);
      INFO("footprint " << width);
      for (std::size_t k = 0; k < 3; ++k) CHECK(found[k] == Approx(row.mean[k]).epsilon(1e-6));
    }
  });
}

TEST_CASE("no footprint changes the mean over the whole pattern") {
  for_each_texture([&](const TransportTier&, const TextureRow& row, const auto& value) {
    for (const double footprint : {0.0, 0.1, 0.3, 0.7, 1.9}) {
      if (row.period == 0) continue;
      INFO("footprint " << footprint);
      const Triad mean =
          mean_over([&](double u, double v) { return value(u, v, footprint); }, 0.013, 0.007, row.period);
      for (std::size_t k = 0; k < 3; ++k)
        CHECK(mean[k] == Approx(row.mean[k]).margin((row.most[k] - row.least[k]) / 32));
    }
  });
}

TEST_CASE("halves, floats and RGBE are computed to the bit, whatever their code") {
  std::vector<std::uint16_t> halves(0x7c00);  // Below infinity.
  std::iota(halves.begin(), halves.end(), std::uint16_t{0});
  Texels exponents;
  exponents.width = 256;
  exponents.height = 1;
  exponents.format = TexelFormat::rgbe;
  for (std::uint32_t e = 0; e < 256; ++e)
    exponents.words.push_back(static_cast<std::int32_t>(e << 24 | 128U << 16 | 1U << 8 | 255U));
  const Texels heights = texels_of_floats(4, 2, 1, {-65504, -1, -0.5F, -0.0F, 0, 0.5F, 1, 65504});
  for (const Texels& texels : {texels_of_words(248, 128, 1, halves.data(), TexelFormat::half), exponents, heights}) {
    Bitmap bitmap;
    bitmap.texels = std::make_shared<const Texels>(texels);
    bitmap.filter = TextureFilter::nearest;
    TextureRow row{"bitmap", {}, {}, {}, {}, 0, {}, {}};
    row.texture.pattern = bitmap;
    const TexelDecoder decoded(texels, {});
    std::vector<TexturePlace> places;
    std::vector<Triad> expected;
    for (std::size_t n = 0; n < texels.count(); ++n) {
      const auto width = static_cast<std::size_t>(texels.width);
      places.push_back({(static_cast<double>(n % width) + 0.5) / texels.width,
                        (static_cast<double>(n / width) + 0.5) / texels.height, 0});
      expected.push_back(decoded(n));
    }
    for (const TransportTier& tier : transport_tiers()) {
      INFO(tier.name << ", " << tier.lanes << " lanes");
      const TierScene scene(scene_of_texture(row), tier);
      CHECK(tier.texture(scene.buffers(), 0, places) == expected);
    }
  }
}

TEST_CASE("every width reads textures as one lane does, to the bit") {
  std::vector<TexturePlace> places;
  std::mt19937_64 engine(6);
  for (int i = 0; i < 37; ++i)
    places.push_back({8 * unit_number(engine) - 4, 8 * unit_number(engine) - 4, i % 3 == 0 ? 0 : unit_number(engine)});
  const double infinite = std::numeric_limits<double>::infinity(), none = std::numeric_limits<double>::quiet_NaN();
  for (const double odd : {0.0, 1.0, -1.0, 2.0, -1e-9, 1e30, infinite, none}) places.push_back({odd, 0.25, 0});
  std::map<std::string, TransportTier> narrow;
  for (const TransportTier& tier : transport_tiers())
    if (tier.lanes == 1) narrow.emplace(tier.name, tier);
  for (const TextureRow& row : texture_rows())
    for (const TransportTier& tier : transport_tiers()) {
      if (tier.lanes == 1) continue;
      INFO(tier.name << ", " << tier.lanes << " lanes, " << row.entry);
      const TierScene wide_scene(scene_of_texture(row), tier), scene(scene_of_texture(row), narrow.at(tier.name));
      const std::vector<Triad> wide = tier.texture(wide_scene.buffers(), 0, places);
      CHECK(wide == narrow.at(tier.name).texture(scene.buffers(), 0, places));
      for (const Triad& value : wide)
        for (const double channel : value) CHECK(channel >= 0);
    }
}

TEST_CASE("filtered bitmaps: points up close, the mean far off, in between the mean stays, at every width") {
  std::vector<Bitmap> all = {bitmap_of(TexelFormat::bits_8, false, TextureFilter::bilinear, TextureWrap::repeat),
                             bitmap_of(TexelFormat::bits_8, true, TextureFilter::bilinear, TextureWrap::mirror)};
  for (const Bitmap& bitmap : all) {
    TextureRow row{"bitmap", {}, {}, {}, {}, 0, {}, {}};
    row.texture.pattern = bitmap;
    const double whole = period(bitmap), infinite = std::numeric_limits<double>::infinity();
    const double mean[] = {bitmap.mean.r, bitmap.mean.g, bitmap.mean.b};
    // Points of a grid over the whole pattern, each with every footprint; a texel is 1/4 wide.
    std::vector<TexturePlace> places;
    const std::vector<double> footprints = {0, 0.2, 0.3, 0.45, 0.7, 1, 1e20, infinite};
    constexpr int side = 32;
    for (const double footprint : footprints)
      for (int i = 0; i < side * side; ++i)
        places.push_back({whole * (i % side + 0.5) / side, whole * (i / side + 0.5) / side, footprint});
    std::vector<Triad> narrow;
    for (const TransportTier& tier : transport_tiers()) {
      INFO(tier.name << ", " << tier.lanes << " lanes");
      RenderSettings settings;
      settings.texture_lod = true;
      const TierScene filtered(scene_of_texture(row), tier, settings), plain(scene_of_texture(row), tier);
      const std::vector<Triad> found = tier.texture(filtered.buffers(), 0, places);
      const std::vector<Triad> points = tier.texture(plain.buffers(), 0, places);
      for (std::size_t k = 0; k < footprints.size(); ++k) {
        INFO("footprint " << footprints[k]);
        const auto first = static_cast<std::ptrdiff_t>(k * side * side), last = first + side * side;
        if (footprints[k] <= 0.2)
          CHECK(std::equal(found.begin() + first, found.begin() + last, points.begin() + first));
        Triad sum{};
        double spread = 0;
        for (auto i = first; i < last; ++i)
          for (std::size_t c = 0; c < 3; ++c) {
            const double one = found[static_cast<std::size_t>(i)][c];
            sum[c] += one / (side * side);
            spread = std::max(spread, std::fabs(one - mean[c]));
          }
        for (std::size_t c = 0; c < 3; ++c) CHECK(sum[c] == Approx(mean[c]).margin(0.01));
        if (footprints[k] >= 1e20) CHECK(spread < 1e-3);
      }
      // Rows behind the first are of parameters that are no colours.
      CHECK(tier.texture(filtered.buffers(), 1, places) == points);
      if (tier.lanes == 1)
        narrow = found;
      else
        CHECK(found == narrow);
    }
  }
}

}  // namespace
