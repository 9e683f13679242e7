// SPDX-License-Identifier: MIT
// Which settings a study of error against time measures, and against what.
//
// Not the product of all axes but planes through one setting, the centre: precision x sampler x samples at the scene's
// depth, depth x sampler x samples at the centre's precision, and the centre's samples once more with the generic
// program (docs/decisions/0012-sweep.md).
#pragma once

#include <vector>

#include "study/tradeoff/setting.h"

namespace strahl {

struct TradeoffAxes {
  std::vector<Precision> precisions;
  std::vector<SamplerKind> samplers{SamplerKind::sobol, SamplerKind::independent};
  std::vector<std::optional<int>> depths;  ///< Without entry: the scene's own; one empty entry: there is none.
  std::vector<int> spps{1, 4, 16, 64, 256};
  bool generic = true;  ///< The centre's row as the generic program too.
};

struct TradeoffPlan {
  std::vector<TradeoffSetting> settings;  ///< Those of one program in a row, their samples ascending.
  TradeoffSetting centre;                 ///< Its samples are the most.
  TradeoffSetting reference;
};

/// 2, 4 and 8 where they are less than the scene's own, and its own; a single empty one where there is none.
[[nodiscard]] std::vector<std::optional<int>> default_depths(const IntegratorSettings& integrator);

/// centre: robust, else the last precision; the deepest of the scene's own, if it is among the axis's, and the axis's
/// deepest; the first sampler. The reference: `precision`, the deepest of the axis and the scene, sobol, `spp`.
/// Throws UsageError for an empty axis, and for depths where the integrator has none.
[[nodiscard]] TradeoffPlan plan_tradeoff(const IntegratorSettings& integrator, TradeoffAxes axes,
                                         Precision reference_precision, int reference_spp);

}  // namespace strahl
