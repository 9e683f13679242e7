// SPDX-License-Identifier: MIT
// The known word that was probably meant by an unknown one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace strahl {

/// Number of insertions, deletions, replacements and swaps of neighbours that turn a into b.
[[nodiscard]] int edit_distance(std::string_view a, std::string_view b);

/// ` (did you mean "radius"?)`, or nothing where no candidate is within a third of the word's length.
[[nodiscard]] std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace strahl
