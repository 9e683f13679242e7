// SPDX-License-Identifier: MIT
// The middle of measured values: what a disturbed run does not move.
#pragma once

#include <vector>

namespace strahl {

/// Of an even number the mean of the middle two; 0 of none.
[[nodiscard]] double median(std::vector<double> values);

}  // namespace strahl
