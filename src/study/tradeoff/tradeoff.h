// SPDX-License-Identifier: MIT
// What error costs in time on a scene: every setting of a plan, measured against one reference.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "opencl/device.h"
#include "study/tradeoff/plan.h"
#include "study/tradeoff/study.h"

namespace strahl {

struct TradeoffOptions {
  TradeoffPlan plan;
  int seeds = 3;               ///< Of each setting, at least 2.
  std::string reference_file;  ///< In place of the plan's reference, which is rendered; empty: none.
  std::string folder;          ///< Where the study lives.
  bool restart = false;        ///< Gives up what another study has in that folder.
  std::string scene_path, command;
  /// By precision, as RenderSettings has it.
  std::map<Precision, std::optional<std::uint64_t>> loop_turns;
};

struct TradeoffProgress {
  double share = 0;  ///< Of the time that it takes, as far as can be told.
  std::string what;  ///< "robust-sobol-d8-64spp-specialised, 12 of 65"
};

/// Called between launches; returning false ends the study: what has been measured stays in the folder.
using TradeoffCallback = std::function<bool(const TradeoffProgress&)>;

/// Takes over what an earlier run of the same study measured, measures the rest, and once it is complete writes
/// tradeoff.json, tradeoff.csv and report.html. The scene's film is that of every picture, without a crop window.
/// Throws UsageError where the folder holds another study or a setting cannot be rendered, and InputError where the
/// reference does not fit: both before anything is written.
[[nodiscard]] TradeoffStudy study_tradeoff(const Device& device, const Scene& scene, const TradeoffOptions& options,
                                           const TradeoffCallback& progress = {});

}  // namespace strahl
