// SPDX-License-Identifier: MIT
#include "cli/clipping.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "kinds/lights.h"
#include "kinds/textures.h"

namespace strahl::cli {
namespace {

/// Fewer overexposed pixels than these are no reason to darken a picture, and as few may stay.
constexpr double few = 0.01;

/// A pixel that shows nothing but a lamp is as bright as the lamp, but for the film's rounding to floats.
constexpr double lamp_share = 0.999;

/// Pixels between which the default filter spreads light: that many beside a lamp are lit by its edge.
constexpr int reach = 2;

bool is_no_darker(const Rgb& a, const Rgb& b) { return a.r >= b.r && a.g >= b.g && a.b >= b.b; }

/// Pixels that show a lamp which is itself brighter than white: no other could have overexposed them. What is as bright
/// as one lamp is as bright as all darker ones, so that few of many lamps are looked at.
class LampPixels {
 public:
  LampPixels(const Image& color, double white, std::vector<Rgb> lamps) : color_(color) {
    std::sort(lamps.begin(), lamps.end(), [](const Rgb& a, const Rgb& b) { return a.r + a.g + a.b < b.r + b.g + b.b; });
    for (const Rgb& lamp : lamps) {
      if (!(std::max({lamp.r, lamp.g, lamp.b}) > white)) continue;
      const auto is_darker = [&](const Rgb& darkest) { return is_no_darker(lamp, darkest); };
      if (std::none_of(darkest_.begin(), darkest_.end(), is_darker)) darkest_.push_back(lamp);
    }
    std::sort(darkest_.begin(), darkest_.end(), [](const Rgb& a, const Rgb& b) { return a.r < b.r; });
    if (!darkest_.empty()) is_lamp_.resize(static_cast<std::size_t>(color.width) * color.height, unknown);
  }
  /// The pixel or one that its edge reaches.
  [[nodiscard]] bool are_near(int x, int y) {
    if (darkest_.empty()) return false;
    for (int v = std::max(y - reach, 0); v <= std::min(y + reach, color_.height - 1); ++v)
      for (int u = std::max(x - reach, 0); u <= std::min(x + reach, color_.width - 1); ++u)
        if (is_lamp(u, v)) return true;
    return false;
  }

 private:
  static constexpr signed char unknown = -1;

  bool is_lamp(int x, int y) {
    signed char& known = is_lamp_[static_cast<std::size_t>(y) * color_.width + x];
    if (known != unknown) return known != 0;
    const float* rgb = &color_.data[color_.index(x, y, 0)];
    const Rgb pixel{static_cast<double>(rgb[0]) / lamp_share, static_cast<double>(rgb[1]) / lamp_share,
                    static_cast<double>(rgb[2]) / lamp_share};
    const auto is_shown = [&](const Rgb& lamp) { return is_no_darker(pixel, lamp); };
    const auto redder = std::upper_bound(darkest_.begin(), darkest_.end(), pixel.r,
                                         [](double r, const Rgb& lamp) { return r < lamp.r; });
    known = std::any_of(darkest_.begin(), redder, is_shown) ? 1 : 0;
    return known != 0;
  }

  const Image& color_;
  std::vector<Rgb> darkest_;
  std::vector<signed char> is_lamp_;
};

}  // namespace

std::vector<Rgb> lamps_of(const Scene& scene) {
  std::vector<Rgb> lamps;
  std::map<int, Rgb> brightest;  // Of textures: each is looked at once, however many shapes have it.
  const auto add = [&](const std::optional<Rgb>& radiance, int texture = -1) {
    if (!radiance || !(std::max({radiance->r, radiance->g, radiance->b}) > 0)) return;
    if (texture < 0) return lamps.push_back(*radiance);
    auto known = brightest.find(texture);
    if (known == brightest.end()) known = brightest.emplace(texture, kinds::brightest(scene, texture)).first;
    lamps.push_back(kinds::times(*radiance, known->second));
  };
  for_each_shape(scene, [&](const Shape& shape) {
    add(shape.radiance, shape.radiance_texture);
    if (const auto* mesh = std::get_if<Mesh>(&shape.geometry))
      for (const MeshPart& part : mesh->parts) add(part.radiance, part.radiance_texture);
  });
  for (const Light& light : scene.lights)
    if (kinds::light_glows(light)) add(kinds::brightest(light));
  return lamps;
}

Clipping clipping_of(const Image& color, double exposure, const std::vector<Rgb>& lamps) {
  const double white = std::exp2(-exposure);
  std::vector<double> overexposed;  // Their largest channels.
  std::size_t clipped = 0;
  LampPixels shown(color, white, lamps);
  for (int y = 0; y < color.height; ++y)
    for (int x = 0; x < color.width; ++x) {
      const float* rgb = &color.data[color.index(x, y, 0)];
      const double brightest = static_cast<double>(std::max({rgb[0], rgb[1], rgb[2]}));
      if (!(brightest > white) || !std::isfinite(brightest)) continue;
      ++clipped;
      if (!shown.are_near(x, y)) overexposed.push_back(brightest);
    }
  const double pixels = static_cast<double>(color.width) * color.height;
  Clipping clipping{static_cast<double>(clipped) / pixels, std::nullopt};
  const auto may_stay = static_cast<std::size_t>(few * pixels);
  if (overexposed.size() <= may_stay) return clipping;
  const auto last = overexposed.end() - 1 - static_cast<std::ptrdiff_t>(may_stay);
  std::nth_element(overexposed.begin(), last, overexposed.end());
  constexpr int most_stops = 64;  // That --exposure takes.
  const int stops = static_cast<int>(std::floor(-std::log2(*last)));
  if (stops >= -most_stops) clipping.stops = stops;
  return clipping;
}

std::string clipping_text(const Clipping& clipping) {
  if (clipping.share == 0) return {};
  const std::string share = clipping.share < 0.001 ? "< 0.1" : fmt::format("{:.1f}", 100 * clipping.share);
  const std::string remedy = clipping.stops ? fmt::format("; --exposure {} shows them", *clipping.stops) : "";
  return fmt::format("{} % of the pixels are brighter than white, which is no part of the error{}", share, remedy);
}

}  // namespace strahl::cli
