// SPDX-License-Identifier: MIT
// How many turns all loops of one work-item can make together (cl/kernels/render.cl, intersect.cl), for devices that
// end loops without a word (device/canary_loops.h): what may be too much for them is refused or split, never rendered
// wrong.
#pragma once

#include <cstdint>
#include <optional>

#include "device/device.h"
#include "render/settings.h"
#include "scene/scene.h"

namespace strahl {

/// Upper bounds, reals because they may be beyond any integer.
struct LoopBound {
  double launch = 0;  ///< Without samples.
  double sample = 0;  ///< More for each sample.
};

[[nodiscard]] LoopBound render_loops(const Scene& scene, int lanes, Acceleration acceleration);
/// One ray is the sample.
[[nodiscard]] LoopBound intersect_loops(const Scene& scene, int lanes, Acceleration acceleration);

/// Whole samples that a work-item may take in one launch where loops end after so many turns.
[[nodiscard]] double samples_within(std::uint64_t loop_turns, const LoopBound& bound);

/// The same, of a device that may have no such end. Throws NoDeviceError where that is none.
[[nodiscard]] int most_samples(const Device& device, const LoopBound& bound, std::optional<std::uint64_t> loop_turns);

}  // namespace strahl
