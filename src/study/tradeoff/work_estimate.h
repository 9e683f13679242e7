// SPDX-License-Identifier: MIT
// How long the rest of some work takes, by what like work took.
#pragma once

#include <map>
#include <optional>
#include <string>

namespace strahl {

class WorkEstimate {
 public:
  void expect(const std::string& kind, double amount) { kinds_[kind].left += amount; }
  void done(const std::string& kind, double amount, double seconds);
  /// A kind that was not begun yet takes what all others took on the average; none before anything was done.
  [[nodiscard]] std::optional<double> seconds_left() const;

 private:
  struct Kind {
    double left = 0, done = 0, seconds = 0;
  };
  std::map<std::string, Kind> kinds_;
};

}  // namespace strahl
