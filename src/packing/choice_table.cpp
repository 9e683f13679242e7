// SPDX-License-Identifier: MIT
#include "packing/choice_table.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace strahl {

std::vector<Choice> choice_table(const std::vector<double>& weights) {
  constexpr std::uint64_t all = std::uint64_t{1} << 32;
  const auto has_weight = [](double weight) { return weight > 0; };
  const auto items = static_cast<std::uint64_t>(weights.size());
  auto after = static_cast<std::uint64_t>(std::count_if(weights.begin(), weights.end(), has_weight));
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  std::vector<Choice> table(weights.size());
  double share = 0;
  std::uint64_t end = 0, part = 0;  // The first number beyond the item; the first part that is not guided yet.
  for (std::uint64_t i = 0; i < items; ++i) {
    share += weights[i] / sum;
    if (has_weight(weights[i])) {
      --after;
      const auto rounded = static_cast<std::uint64_t>(std::llround(std::ldexp(std::min(share, 1.0), 32)));
      end = after == 0 ? all : std::clamp(rounded, end + 1, all - after);
    }
    table[i].last = static_cast<std::uint32_t>(std::max<std::uint64_t>(end, 1) - 1);
    for (; part < items && (part * all + items - 1) / items < end; ++part)
      table[part].guide = static_cast<std::int32_t>(i);
  }
  return table;
}

std::vector<double> choice_rarities(const std::vector<Choice>& table, const std::vector<double>& weights) {
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  std::vector<double> by_numbers, by_weights;
  bool are_alike = true;
  std::uint64_t begin = 0;
  for (std::size_t i = 0; i < table.size(); ++i) {
    by_weights.push_back(sum / weights[i]);
    // Behind items of weight 0 at the front the first number is still to be taken.
    const std::uint64_t end = weights[i] > 0 ? std::uint64_t{table[i].last} + 1 : begin;
    by_numbers.push_back(std::ldexp(1 / static_cast<double>(end - begin), 32));
    if (weights[i] > 0) are_alike = are_alike && std::fabs(by_numbers[i] / by_weights[i] - 1) <= 0x1p-24;
    begin = end;
  }
  return are_alike ? by_weights : by_numbers;
}

}  // namespace strahl
