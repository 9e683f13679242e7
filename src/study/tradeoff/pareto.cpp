// SPDX-License-Identifier: MIT
#include "study/tradeoff/pareto.h"

#include <algorithm>

namespace strahl {

std::vector<bool> pareto_front(const std::vector<Cost>& costs) {
  const auto beats = [](const Cost& a, const Cost& b) {
    return a.seconds <= b.seconds && a.error <= b.error && (a.seconds < b.seconds || a.error < b.error);
  };
  std::vector<bool> front;
  for (const Cost& cost : costs)
    front.push_back(std::none_of(costs.begin(), costs.end(), [&](const Cost& other) { return beats(other, cost); }));
  return front;
}

}  // namespace strahl
