// SPDX-License-Identifier: MIT
// Which of several results nothing beats in both time and error.
#pragma once

#include <vector>

namespace strahl {

struct Cost {
  double seconds = 0;
  double error = 0;
};

/// One a result: true where no other is at least as fast and as good, and one of the two strictly.
[[nodiscard]] std::vector<bool> pareto_front(const std::vector<Cost>& costs);

}  // namespace strahl
