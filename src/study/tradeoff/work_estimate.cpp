// SPDX-License-Identifier: MIT
#include "study/tradeoff/work_estimate.h"

#include <algorithm>

namespace strahl {

void WorkEstimate::done(const std::string& kind, double amount, double seconds) {
  Kind& of = kinds_[kind];
  of.left = std::max(0.0, of.left - amount);
  of.done += amount;
  of.seconds += seconds;
}

std::optional<double> WorkEstimate::seconds_left() const {
  double done = 0, seconds = 0, left = 0;
  for (const auto& [name, kind] : kinds_) {
    done += kind.done;
    seconds += kind.seconds;
  }
  if (!(done > 0)) return std::nullopt;
  for (const auto& [name, kind] : kinds_)
    left += kind.left * (kind.done > 0 ? kind.seconds / kind.done : seconds / done);
  return left;
}

}  // namespace strahl
