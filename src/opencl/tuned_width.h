// SPDX-License-Identifier: MIT
// The tree's width that `strahl bench --tune` found fastest on a device, kept beside the cached programs until the
// driver changes or the cache is cleared. Results do not depend on it.
#pragma once

#include <optional>

#include "opencl/device.h"
#include "program/program_text.h"

namespace strahl {

/// None: nobody has measured.
[[nodiscard]] std::optional<int> tuned_width(const Device& device, Precision precision);
/// Throws Error where the cache cannot be written to.
void remember_width(const Device& device, Precision precision, int width);

/// What the settings say, else what was remembered, else what suits the device.
[[nodiscard]] Width width_on(const Device& device, RenderSettings settings);

}  // namespace strahl
