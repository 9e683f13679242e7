// SPDX-License-Identifier: MIT
// What devices count of samples that a picture is told of with: what was cut, replaced or left out.
#pragma once

#include <cstdint>

namespace strahl {

struct UnusualSamples {
  std::uint64_t saturated = 0;        ///< Sample channels beyond the largest float, counted as it.
  std::uint64_t invalid = 0;          ///< NaN sample channels, counted as black.
  std::uint64_t weak_branches = 0;    ///< Rays that whitted did not follow: weaker than 2^-20 of the camera ray.
  std::uint64_t lost_branches = 0;    ///< Others that it did not follow: beyond layout::WHITTED_MOST_RAYS of a sample.
  std::uint64_t lost_interfaces = 0;  ///< Surfaces of glass with a priority that could not be tracked: no free place.

  [[nodiscard]] std::uint64_t not_finite() const { return saturated + invalid; }

  UnusualSamples& operator+=(const UnusualSamples& other) {
    saturated += other.saturated;
    invalid += other.invalid;
    weak_branches += other.weak_branches;
    lost_branches += other.lost_branches;
    lost_interfaces += other.lost_interfaces;
    return *this;
  }
  friend bool operator==(const UnusualSamples&, const UnusualSamples&) = default;
};

}  // namespace strahl
