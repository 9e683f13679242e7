// SPDX-License-Identifier: MIT
// Where samples begin among the OpenCL calls of a render whose program and whose canary's answer are cached.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

namespace strahl_test {

inline const char* const launch_call = "clEnqueueNDRangeKernel";

/// Of pixels that share samples: one follows paths, one gathers what they bring.
constexpr int kernels_a_launch = 2;

/// Without pixels: each renderer warms up its program, then measures what a launch costs. Counted in kernels.
constexpr int warm_up_launches = 2 * kernels_a_launch;

/// The first launch of samples, counted from 1, of so many devices. The film's clearing comes before it, of which a
/// thread does a part at any time; the calls are as many in any case.
inline std::size_t first_launch(const std::vector<std::string>& calls, int devices = 1) {
  int left = warm_up_launches * devices;
  const auto launch = std::find_if(calls.begin(), calls.end(),
                                   [&](const std::string& call) { return call == launch_call && left-- == 0; });
  REQUIRE(launch != calls.end());
  return static_cast<std::size_t>(launch - calls.begin()) + 1;
}

}  // namespace strahl_test
