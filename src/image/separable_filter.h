// SPDX-License-Identifier: MIT
// A filter in two passes, along rows and along columns.
#pragma once

#include <vector>

#include "image/channel.h"

namespace strahl {

/// What lies outside of a picture of columns a b c: mirror: b a | a b c | c b; repeat: a a | a b c | c c.
enum class Border { mirror, repeat };

/// result(x) = sum over k of weights[k] channel(x + k - radius); the number of weights is 2 radius + 1.
[[nodiscard]] Channel filter_rows(const Channel& channel, const std::vector<double>& weights, Border border);
/// The same along y.
[[nodiscard]] Channel filter_columns(const Channel& channel, const std::vector<double>& weights, Border border);

}  // namespace strahl
