// SPDX-License-Identifier: MIT
// A study as text for programs: JSON and CSV (docs/tradeoff.md).
#pragma once

#include <optional>
#include <string>

#include "study/tradeoff/study.h"

namespace strahl {

/// File names of a setting's pictures within the study's folder, as its JSON has them.
[[nodiscard]] std::string picture_name(const TradeoffSetting& setting);
[[nodiscard]] std::string difference_name(const TradeoffSetting& setting);
inline constexpr char reference_picture_name[] = "reference.png";

[[nodiscard]] std::string tradeoff_json(const TradeoffStudy& study);
/// A row a point, the JSON's names as columns; of nested ones "seconds.kernel". What is null is empty.
[[nodiscard]] std::string tradeoff_csv(const TradeoffStudy& study);

/// A point by itself, and back; `study`: of which study it is a part. None where the text is no point of that study
/// with every metric.
[[nodiscard]] std::string point_json(const TradeoffPoint& point, const std::string& study);
[[nodiscard]] std::optional<TradeoffPoint> point_from_json(const std::string& text, const std::string& study);

}  // namespace strahl
