// SPDX-License-Identifier: MIT
// One setting with several seeds: what its pictures take and how far off they are.
#pragma once

#include <functional>
#include <optional>

#include "render/renderer.h"
#include "study/tradeoff/study.h"

namespace strahl {

/// Seeds 1, 2, ... are the points', so that no picture shares its noise with the reference.
inline constexpr std::uint32_t reference_seed = 0;

struct MeasuredPoint {
  TradeoffPoint point;
  Image picture;  ///< Of the first seed.
};

/// renderer: made for settings with this one's program. seconds.wall is the preparation plus a render. None where the
/// callback stopped it.
[[nodiscard]] std::optional<MeasuredPoint> measure_point(Renderer& renderer, const TradeoffSetting& setting, int seeds,
                                                         const TradeoffReference& reference,
                                                         const ProgressCallback& progress);

}  // namespace strahl
