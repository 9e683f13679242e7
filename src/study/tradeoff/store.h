// SPDX-License-Identifier: MIT
// A study's folder: what has been measured stays measured when the run is interrupted, killed or asked for more.
//
// Each file is complete or absent, and a point's JSON is written after its pictures, so what has one is whole.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/tradeoff/identity.h"
#include "study/tradeoff/study.h"

namespace strahl {

/// Names of the files that a study writes into its folder, and of the folder of its points.
[[nodiscard]] std::vector<std::string> study_file_names();
inline constexpr char study_points_name[] = "points";

class TradeoffStore {
 public:
  /// Creates the folder. Throws Error where that fails, and UsageError where it holds a study of another identity,
  /// which `restart` gives up.
  TradeoffStore(std::string folder, const StudyIdentity& identity, bool restart);

  [[nodiscard]] std::string path(const std::string& name) const;
  /// As an earlier run measured it.
  [[nodiscard]] std::optional<TradeoffPoint> point(const TradeoffSetting& setting) const;
  [[nodiscard]] std::optional<TradeoffReference> reference(const TradeoffSetting& setting) const;

  void keep(const TradeoffPoint& point, const Image& picture, const Image& difference, double exposure) const;
  void keep(const TradeoffReference& reference) const;

  /// tradeoff.json, tradeoff.csv and report.html.
  void publish(const TradeoffStudy& study) const;

 private:
  std::string folder_;
  std::string study_;  ///< The identity's hash.
};

}  // namespace strahl
