// SPDX-License-Identifier: MIT
// A study of error against time for people: its Pareto front and slopes.
#pragma once

#include <string>

#include "study/tradeoff/study.h"

namespace strahl::cli {

/// The front from the fastest setting to the most exact one, then the fitted slopes.
[[nodiscard]] std::string tradeoff_table(const TradeoffStudy& study);

}  // namespace strahl::cli
