// SPDX-License-Identifier: MIT
// Whether a device lets loops run to their end. Mesa's llvmpipe ends all loops of a work-item after 65,535 turns in
// sum, without a word; whether a work-item can tell afterwards (cl/kernels/whole_loops.h) is asked as well.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "opencl/device.h"

namespace strahl {

/// `outer` turns, each with a loop of `inner` turns in it.
struct LoopCase {
  std::uint32_t outer, inner;
  [[nodiscard]] constexpr std::uint64_t turns() const { return std::uint64_t{outer} * (std::uint64_t{inner} + 1); }
};

inline constexpr std::array<LoopCase, 3> loop_cases{{{1, 100000}, {200, 500}, {20, 5}}};

struct LoopTurns {
  std::array<std::uint64_t, loop_cases.size()> made{};
  std::array<bool, loop_cases.size()> are_whole{};  ///< As the work-item itself can tell.
  /// Turns in sum over all loops of a work-item that are safe; none: all that were asked for have been made.
  [[nodiscard]] std::optional<std::uint64_t> limit() const;
  /// Work-items are right about what they tell.
  [[nodiscard]] bool can_be_told() const;
};

/// program: of kernels/canary.cl.
[[nodiscard]] LoopTurns turns_made(const Device& device, const cl::Program& program);

}  // namespace strahl
