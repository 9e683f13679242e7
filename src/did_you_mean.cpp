// SPDX-License-Identifier: MIT
// Optimal string alignment distance (Damerau, "A technique for computer detection and correction of spelling
// errors", CACM 7(3), 1964), by dynamic programming.
#include "did_you_mean.h"

#include <fmt/format.h>

#include <algorithm>

namespace strahl {

int edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<int>> d(a.size() + 1, std::vector<int>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = static_cast<int>(i);
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replace = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      d[i][j] = std::min({replace, d[i - 1][j] + 1, d[i][j - 1] + 1});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates) {
  constexpr std::size_t longest_word = 64;  // No name that strahl knows is longer; the table stays small.
  if (word.size() > longest_word) return {};
  int best_distance = std::max(1, static_cast<int>((word.size() + 2) / 3)) + 1;
  std::string best;
  const auto difference = [&](const std::string& other) {
    return static_cast<int>(std::max(word.size(), other.size()) - std::min(word.size(), other.size()));
  };
  for (const std::string& candidate : candidates) {
    if (difference(candidate) >= best_distance) continue;  // So is the distance.
    const int distance = edit_distance(word, candidate);
    if (distance >= best_distance || distance >= static_cast<int>(candidate.size())) continue;
    best_distance = distance;
    best = candidate;
  }
  return best.empty() ? std::string{} : fmt::format(" (did you mean \"{}\"?)", best);
}

}  // namespace strahl
