// SPDX-License-Identifier: MIT
// SplitMix64 (Steele, Lea, Flood, "Fast Splittable Pseudorandom Number Generators", OOPSLA 2014): the same numbers from
// the same seed on every platform, which the standard library's distributions do not promise.
#pragma once

#include <cmath>
#include <cstdint>

namespace strahl::oracle {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  [[nodiscard]] std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  /// In [0, 1), multiples of 2^-53.
  [[nodiscard]] double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  [[nodiscard]] double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// An integer in [low, high].
  [[nodiscard]] int integer(int low, int high) {
    return low + static_cast<int>(bits() % static_cast<std::uint64_t>(high - low + 1));
  }
  /// 1 or -1.
  [[nodiscard]] int sign() { return bits() >> 63 ? 1 : -1; }
  /// 10^x with x even in [low, high], either sign.
  [[nodiscard]] double log_uniform(double low, double high) {
    const double magnitude = std::pow(10.0, uniform(low, high));
    return sign() * magnitude;
  }

 private:
  std::uint64_t state_;
};

}  // namespace strahl::oracle
