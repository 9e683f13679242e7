// SPDX-License-Identifier: MIT
// Whether a program is being compiled right now: a compiler tells nobody how far it is, and takes 1 to 16 s.
#pragma once

#include <atomic>

namespace strahl {

/// Around a call that may compile.
class Compiling {
 public:
  Compiling() { ++under_way; }
  ~Compiling() { --under_way; }
  Compiling(const Compiling&) = delete;
  Compiling& operator=(const Compiling&) = delete;

  /// For other threads to ask.
  [[nodiscard]] static bool is_under_way() { return under_way > 0; }

 private:
  static inline std::atomic<int> under_way{0};
};

}  // namespace strahl
