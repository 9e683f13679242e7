// SPDX-License-Identifier: MIT
// What a study of error against time holds; docs/tradeoff.md defines every number.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "image/metrics.h"
#include "render/unusual_samples.h"
#include "study/tradeoff/error_parts.h"
#include "study/tradeoff/power_law.h"
#include "study/tradeoff/setting.h"

namespace strahl {

/// What compare_images says of a point: all but what ErrorParts has, and HDR-FLIP, which takes longer than the
/// pictures.
[[nodiscard]] std::vector<Metric> study_metrics();

/// Of one picture.
struct PointSeconds {
  double program = 0, bvh = 0, upload = 0, kernel = 0, wall = 0;
};

/// One setting, measured.
struct TradeoffPoint {
  TradeoffSetting setting;
  int seeds = 0;
  PointSeconds seconds;             ///< Medians over the seeds.
  std::string program;              ///< Its hash.
  bool program_from_cache = false;  ///< seconds.program is not what building it takes.
  ErrorParts error;
  std::vector<std::pair<std::string, double>> metrics;  ///< study_metrics, means over seeds; NaN: has an obstacle.
  UnusualSamples unusual;                               ///< Of all seeds together.
  bool pareto = false;
};

/// Error against time over the samples of what is otherwise one setting.
struct TradeoffFit {
  TradeoffSetting setting;          ///< Its samples mean nothing.
  PowerLaw seconds;                 ///< RMSE against kernel seconds,
  std::optional<PowerLaw> samples;  ///< and against samples a pixel.
};

/// What errors are measured against.
struct TradeoffReference {
  Image picture;
  std::string source;                               ///< Somebody's file; empty: rendered with
  std::optional<TradeoffSetting> setting;           ///< this.
  std::optional<double> seconds;                    ///< Of its kernel.
  std::optional<double> rmse, rmse_low, rmse_high;  ///< Its own; none where that is unknown.
};

struct TradeoffStudy {
  std::string scene_path, scene_name, device, command;
  TradeoffReference reference;
  std::vector<TradeoffPoint> points;
  std::vector<TradeoffFit> fits;
  int taken_over = 0;    ///< Of the points: measured by an earlier run.
  bool complete = true;  ///< false: stopped; `points` are those that there are.
};

/// Marks the front of error against kernel seconds and fits every row of three points or more.
void conclude(TradeoffStudy& study);

}  // namespace strahl
