// SPDX-License-Identifier: MIT
#include "packing/alias_table.h"

#include <cmath>
#include <numeric>

namespace strahl {

std::vector<Choice> alias_table(const std::vector<double>& weights) {
  const double mean = std::accumulate(weights.begin(), weights.end(), 0.0) / static_cast<double>(weights.size());
  std::vector<double> rest(weights.size());
  std::vector<std::size_t> small, large;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    rest[i] = weights[i] / mean;
    (rest[i] < 1 ? small : large).push_back(i);
  }
  std::vector<Choice> table(weights.size());
  for (std::size_t i = 0; i < table.size(); ++i) table[i].other = static_cast<std::int32_t>(i);
  while (!small.empty() && !large.empty()) {
    const std::size_t less = small.back(), more = large.back();
    small.pop_back();
    table[less] = {static_cast<std::uint32_t>(std::ldexp(rest[less], 32)), static_cast<std::int32_t>(more)};
    rest[more] -= 1 - rest[less];
    if (rest[more] < 1) {
      large.pop_back();
      small.push_back(more);
    }
  }
  return table;
}

}  // namespace strahl
