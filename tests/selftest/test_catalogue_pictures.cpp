// SPDX-License-Identifier: MIT
// Pictures of the catalogue, rendered on PoCL in the robust tier by one generic program: one sample through the middle
// of every pixel. No value is NaN, no colour negative or infinite, something is seen, and the row's own check holds.
// 4 s where no program is cached.
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <set>

#include "render/pictures.h"
#include "scene/scene_text.h"
#include "selftest/catalogue.h"

using namespace strahl;
using namespace strahl::selftest;
using namespace strahl::test;

namespace {

enum Channel { depth, normal_x, normal_y, normal_z, u, v, shape };

struct Rendered {
  Scene scene;
  Image color, aov;

  [[nodiscard]] bool is_hit(int x, int y) const { return aov.at(x, y, shape) >= 0; }
};

template <class Demand>
bool holds_everywhere(const Image& image, Demand demand) {
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (!demand(x, y)) return false;
  return true;
}

// Each check looks at one picture and at the first of its row.

bool finite(const Rendered& picture, const Rendered&) {
  const auto is_sound = [](float x) { return std::isfinite(x) && x >= 0; };
  const auto is_number = [](float x) { return !std::isnan(x); };
  bool is_anything_hit = false;
  (void)holds_everywhere(picture.aov, [&](int x, int y) { return is_anything_hit |= picture.is_hit(x, y), true; });
  return is_anything_hit && std::all_of(picture.color.data.begin(), picture.color.data.end(), is_sound) &&
         std::all_of(picture.aov.data.begin(), picture.aov.data.end(), is_number);
}

bool uv_in_unit_square(const Rendered& picture, const Rendered&) {
  return holds_everywhere(picture.aov, [&](int x, int y) {
    const float s = picture.aov.at(x, y, u), t = picture.aov.at(x, y, v);
    return s >= 0 && s <= 1 && t >= 0 && t <= 1;
  });
}

bool weights_of_a_triangle(const Rendered& picture, const Rendered&) {
  return holds_everywhere(picture.aov, [&](int x, int y) {
    const float s = picture.aov.at(x, y, u), t = picture.aov.at(x, y, v);
    return s >= 0 && t >= 0 && s + t <= 1 + 0x1p-23F;
  });
}

/// From the sky above to the ground below.
bool one_change_a_column(const Rendered& picture, const Rendered&) {
  for (int x = 0; x < picture.aov.width; ++x) {
    int changes = 0;
    for (int y = 1; y < picture.aov.height; ++y) changes += picture.is_hit(x, y) != picture.is_hit(x, y - 1);
    if (changes != 1 || picture.is_hit(x, 0)) return false;
  }
  return true;
}

bool symmetric(const Rendered& picture, const Rendered&) {
  const Image& aov = picture.aov;
  return holds_everywhere(aov, [&](int x, int y) {
    const float here = aov.at(x, y, depth);
    return here == aov.at(aov.width - 1 - x, y, depth) && here == aov.at(x, aov.height - 1 - y, depth);
  });
}

/// The bits of everything but distances.
bool same_as_first(const Rendered& picture, const Rendered& first) {
  if (!same_bits(picture.color, first.color)) return false;
  return holds_everywhere(first.aov, [&](int x, int y) {
    for (const Channel c : {normal_x, normal_y, normal_z, u, v, shape})
      if (picture.aov.at(x, y, c) != first.aov.at(x, y, c)) return false;
    return true;
  });
}

bool all_shapes_seen(const Rendered& picture, const Rendered&) {
  std::set<float> seen;
  (void)holds_everywhere(picture.aov, [&](int x, int y) { return seen.insert(picture.aov.at(x, y, shape)), true; });
  seen.erase(-1);
  return seen.size() == picture.scene.shapes.size();
}

bool all_hit(const Rendered& picture, const Rendered&) {
  return holds_everywhere(picture.aov, [&](int x, int y) { return picture.is_hit(x, y); });
}

/// Colours of the checkerboards, in squares of 8 x 8 pixels.
bool two_tones(const Rendered& picture, const Rendered&) {
  std::set<float> tones;
  (void)holds_everywhere(picture.color, [&](int x, int y) { return tones.insert(picture.color.at(x, y, 0)), true; });
  return tones == std::set<float>{0.25F, 0.75F};
}

/// Whether the pixels that many further right and down have the same colour.
bool repeats(const Image& color, int after, bool is_same) {
  return holds_everywhere(color, [&](int x, int y) {
    const float here = color.at(x, y, 0);
    return (x + after >= color.width || (color.at(x + after, y, 0) == here) == is_same) &&
           (y + after >= color.height || (color.at(x, y + after, 0) == here) == is_same);
  });
}

bool squares_alternate(const Rendered& picture, const Rendered& first) {
  return two_tones(picture, first) && repeats(picture.color, 8, false);
}

bool squares_repeat(const Rendered& picture, const Rendered& first) {
  return two_tones(picture, first) && repeats(picture.color, 16, true);
}

/// The filter's remainder is half a square over its width: some 2^-7 where floats are 8 squares apart.
bool even_grey(const Rendered& picture, const Rendered&) {
  return holds_everywhere(picture.color,
                          [&](int x, int y) { return std::fabs(picture.color.at(x, y, 0) - 0.5F) <= 0x1p-6F; });
}

const std::map<std::string, bool (*)(const Rendered&, const Rendered&)> checks = {
    {"finite", finite},
    {"uv_in_unit_square", uv_in_unit_square},
    {"weights_of_a_triangle", weights_of_a_triangle},
    {"one_change_a_column", one_change_a_column},
    {"symmetric", symmetric},
    {"same_as_first", same_as_first},
    {"all_shapes_seen", all_shapes_seen},
    {"all_hit", all_hit},
    {"two_tones", two_tones},
    {"squares_alternate", squares_alternate},
    {"squares_repeat", squares_repeat},
    {"even_grey", even_grey},
};

Rendered rendered(const std::string& text) {
  Rendered picture;
  LoadedScene loaded = load_text(text);
  for (const Diagnostic& warning : loaded.warnings) FAIL_CHECK(warning.text());
  picture.scene = std::move(loaded.scene);
  picture.scene.sampler.kind = SamplerKind::centre;
  picture.scene.sampler.sample_count = 1;
  RenderSettings settings;
  settings.precision = Precision::robust;
  settings.generic = true;
  settings.aovs = {Aov::depth, Aov::normal, Aov::uv, Aov::shape_id};
  RenderResult result = render("pocl", picture.scene, settings);
  picture.color = std::move(result.color);
  picture.aov = std::move(result.aov);
  return picture;
}

}  // namespace

TEST_CASE("the pictures of the catalogue pass their checks") {
  require_pocl();
  std::set<std::string> used;
  for (const Row& row : catalogue()) {
    std::vector<Rendered> pictures;
    for (const Picture& picture : row.pictures) {
      INFO("[" << row.id << "] " << row.title << ": " << picture.check << "\n" << picture.scene);
      const auto check = checks.find(picture.check);
      REQUIRE(check != checks.end());
      used.insert(picture.check);
      pictures.push_back(rendered(picture.scene));
      CHECK(finite(pictures.back(), pictures.front()));
      CHECK(check->second(pictures.back(), pictures.front()));
    }
  }
  CHECK(used.size() == checks.size());
}
