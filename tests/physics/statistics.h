// SPDX-License-Identifier: MIT
// Numbers to draw with, and tests of what is drawn.
#pragma once

#include <catch2/catch.hpp>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace strahl::test {

/// An odd multiple of 2^-24: exact in either precision, within (0, 1).
[[nodiscard]] inline double unit_number(std::mt19937_64& engine) {
  return (static_cast<double>(engine() >> 41) + 0.5) * 0x1p-23;
}

/// How many draws a density is held to: STRAHL_DRAWS, else `usual`.
[[nodiscard]] inline std::size_t draws_asked(std::size_t usual) {
  const char* asked = std::getenv("STRAHL_DRAWS");
  return asked == nullptr ? usual : static_cast<std::size_t>(std::stod(asked));
}

/// Compares counts with expected values: chi^2 over the bins that expect five or more, within six standard deviations.
inline void hold_counts(const std::vector<double>& counts, const std::vector<double>& expected) {
  double chi = 0;
  int bins = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (expected[i] < 5) {
      CHECK(counts[i] <= 5 + 5 * std::sqrt(expected[i] + 1));
      continue;
    }
    chi += (counts[i] - expected[i]) * (counts[i] - expected[i]) / expected[i];
    ++bins;
  }
  if (bins > 1) CHECK(chi / bins < 1 + 6 * std::sqrt(2.0 / bins));
}

/// Mean and its standard deviation.
struct Mean {
  double value, noise;
};

[[nodiscard]] inline Mean mean_of(const std::vector<double>& values) {
  const double n = static_cast<double>(values.size()), mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  double squares = 0;
  for (const double x : values) squares += (x - mean) * (x - mean);
  return {mean, std::sqrt(squares) / n};
}

}  // namespace strahl::test
