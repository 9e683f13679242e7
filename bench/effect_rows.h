// SPDX-License-Identifier: MIT
// What each effect costs: a scene that calls for it, by its own program and by the one without it.
#pragma once

#include <string>
#include <vector>

#include "bench/effects.h"
#include "study/effect_costs.h"

namespace strahl::bench {

struct EffectRow {
  std::string effect;  ///< As `strahl explain` names it.
  std::string scene;
  VariantTimes own;  ///< Of the scene's program.
  EffectCost cost;   ///< What the effect adds to it.
};

/// A row for each effect that one of the scenes calls for and can do without, from the scene of its name, else from the
/// first that has it. Throws Error.
[[nodiscard]] std::vector<EffectRow> measure_effect_rows(const Device& device, const EffectsOptions& options,
                                                         const EffectsProgress& progress);

[[nodiscard]] std::string json(const std::vector<EffectRow>& rows, const Device& device);
[[nodiscard]] std::string markdown(const std::vector<EffectRow>& rows, const Device& device);

}  // namespace strahl::bench
