// SPDX-License-Identifier: MIT
// What pictures of light paths cannot have (docs/decisions/0032-light-tracing.md): each is refused, with the reason.
#pragma once

#include <cstdint>

#include "opencl/device.h"
#include "scene/model/scene.h"
#include "settings/settings.h"

namespace strahl {

/// Throws UsageError or SceneError where the integrator's paths begin on lights and the scene or the settings ask for
/// what only paths from the camera have.
void require_light_paths(const Scene& scene, const RenderSettings& settings);

/// Samples of a pixel at the most, so that no more than 2^31 paths go into a sum. A word holds 2^31 splats, whatever
/// they are (film/splat.h), and a path makes up to max_depth + 1 of them, as a rule into different pixels. So the words
/// hold as long as no single pixel gets more than one splat of each path of the picture on average.
[[nodiscard]] int most_light_paths(const Window& window, bool has_error_sums);

/// Throws NoDeviceError where the film's bytes do not fit.
void require_room_for_splats(const DeviceInfo& device, std::uint64_t bytes, std::uint64_t memory_left);

}  // namespace strahl
