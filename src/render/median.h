// SPDX-License-Identifier: MIT
// The median of measured values, which single disturbed runs do not change.
#pragma once

#include <vector>

namespace strahl {

/// For an even number of values the mean of the middle two; 0 for no values.
[[nodiscard]] double median(std::vector<double> values);

}  // namespace strahl
