// SPDX-License-Identifier: MIT
// What each effect of a scene adds to its program and to a frame: measured with and without it.
#pragma once

#include <map>
#include <set>
#include <string>

#include "study/variants.h"

namespace strahl {

/// What an effect adds; negative where the program without it is the larger or slower one.
struct EffectCost {
  std::string needed;        ///< Why there is no program without it; empty: there is one.
  std::string frame_needed;  ///< Why its frame says nothing; empty: it is timed.
  double program_bytes = 0;
  double build_seconds = 0;
  double kernel_seconds = 0;  ///< Of a timed frame: median of the rounds' differences.
  double kernel_share = 0;    ///< Of the frame with it.
  double private_bytes = 0;   ///< Of a work-item.
};

struct EffectCosts {
  VariantStudy study;                         ///< Its first variant is the scene's own program.
  std::map<std::string, EffectCost> effects;  ///< Those that are on.
};

/// Builds the scene's program and one without each effect that can be left out; of those named, where some are.
[[nodiscard]] EffectCosts measure_effects(const Device& device, const Scene& scene, const RenderSettings& settings,
                                          const VariantRounds& rounds, const StudyProgress& progress = {},
                                          const std::set<std::string>& names = {});

}  // namespace strahl
