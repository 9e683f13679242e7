// SPDX-License-Identifier: MIT
// Wall time since construction.
#pragma once

#include <chrono>

namespace strahl {

class Stopwatch {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace strahl
