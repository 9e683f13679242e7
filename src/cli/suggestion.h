// SPDX-License-Identifier: MIT
// The nearest of the known words, for a mistyped one.
#pragma once

#include <string>
#include <vector>

namespace strahl::cli {

/// ` (did you mean "x"?)`, or nothing where no candidate is near.
[[nodiscard]] std::string suggestion(const std::string& word, const std::vector<std::string>& candidates);

}  // namespace strahl::cli
