// SPDX-License-Identifier: MIT
// What a file that ends at white cannot show: how many pixels, and whether another exposure would help.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "image/image.h"
#include "scene/model/scene.h"

namespace strahl::cli {

struct Clipping {
  double share = 0;          ///< Of the pixels: those with a channel above white.
  std::optional<int> stops;  ///< --exposure that shows nearly all of them but the lamps; none where nothing is gained.
};

/// Radiances of what can be in sight and shines by itself.
[[nodiscard]] std::vector<Rgb> lamps_of(const Scene& scene);

/// color: linear RGB. A lamp in sight is meant to be brighter than white, so no exposure is advised for its pixels, nor
/// for their neighbours, which the lamp covers in part.
[[nodiscard]] Clipping clipping_of(const Image& color, double exposure, const std::vector<Rgb>& lamps);

/// "2.3 % of the pixels are brighter than white (no part of this error)"; empty where there are none.
[[nodiscard]] std::string clipping_text(const Clipping& clipping);

}  // namespace strahl::cli
