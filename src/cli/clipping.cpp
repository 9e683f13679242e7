// SPDX-License-Identifier: MIT
#include "cli/clipping.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

bool is_lamp(const float* rgb, const std::vector<Rgb>& lamps) {
  return std::any_of(lamps.begin(), lamps.end(), [&](const Rgb& lamp) {
    return static_cast<double>(rgb[0]) >= lamp_share * lamp.r && static_cast<double>(rgb[1]) >= lamp_share * lamp.g &&
           static_cast<double>(rgb[2]) >= lamp_share * lamp.b;
  });
}

}  // namespace

std::vector<Rgb> lamps_of(const Scene& scene) {
  std::vector<Rgb> lamps;
  const auto add = [&](const std::optional<Rgb>& radiance, int texture = -1) {
    if (!radiance || !(std::max({radiance->r, radiance->g, radiance->b}) > 0)) return;
    lamps.push_back(texture < 0 ? *radiance : kinds::times(*radiance, kinds::brightest(scene, texture)));
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
  const auto shows_a_lamp = [&](int x, int y) {
    for (int v = std::max(y - reach, 0); v <= std::min(y + reach, color.height - 1); ++v)
      for (int u = std::max(x - reach, 0); u <= std::min(x + reach, color.width - 1); ++u)
        if (is_lamp(&color.data[color.index(u, v, 0)], lamps)) return true;
    return false;
  };
  for (int y = 0; y < color.height; ++y)
    for (int x = 0; x < color.width; ++x) {
      const float* rgb = &color.data[color.index(x, y, 0)];
      const double brightest = static_cast<double>(std::max({rgb[0], rgb[1], rgb[2]}));
      if (!(brightest > white) || !std::isfinite(brightest)) continue;
      ++clipped;
      if (!shows_a_lamp(x, y)) overexposed.push_back(brightest);
    }
  const double pixels = static_cast<double>(color.width) * color.height;
  Clipping clipping{static_cast<double>(clipped) / pixels, std::nullopt};
  const auto may_stay = static_cast<std::size_t>(few * pixels);
  if (overexposed.size() <= may_stay) return clipping;
  const auto last = overexposed.end() - 1 - static_cast<std::ptrdiff_t>(may_stay);
  std::nth_element(overexposed.begin(), last, overexposed.end());
  clipping.stops = static_cast<int>(std::floor(-std::log2(*last)));
  return clipping;
}

std::string clipping_text(const Clipping& clipping) {
  if (clipping.share == 0) return {};
  const std::string share = clipping.share < 0.001 ? "< 0.1" : fmt::format("{:.1f}", 100 * clipping.share);
  const std::string remedy = clipping.stops ? fmt::format("; --exposure {} shows them", *clipping.stops) : "";
  return fmt::format("{} % of the pixels are brighter than white, which is no part of the error{}", share, remedy);
}

}  // namespace strahl::cli
