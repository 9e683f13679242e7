// SPDX-License-Identifier: MIT
// Random numbers by their number, not in a row: what is made of them does not depend on the order in which it is made.
// The finisher of SplitMix64 (Steele, Lea, Flood, OOPSLA 2014).
#pragma once

#include <cstdint>

namespace strahl {

[[nodiscard]] constexpr std::uint64_t hashed(std::uint64_t number) {
  std::uint64_t z = (number + 1) * 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// In [0, 1).
[[nodiscard]] constexpr double hashed_uniform(std::uint64_t number) {
  return static_cast<double>(hashed(number) >> 11) * 0x1p-53;
}

}  // namespace strahl
