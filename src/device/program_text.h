// SPDX-License-Identifier: MIT
// The complete program for a kernel file: prelude (precision, lanes, flags) and expanded sources.
#pragma once

#include "device/features.h"
#include "device/program.h"

namespace strahl {

/// root: "kernels/render.cl". Equal features, precision and lanes give equal text, whatever the scene's values.
[[nodiscard]] ProgramSource program_source(const std::string& root, const Features& features, Precision precision,
                                           int lanes);

/// Lanes for a device: 16 or 8 where its native float vectors are that wide, 1 where it runs work-items in lanes.
[[nodiscard]] int default_lanes(unsigned native_vector_width, Precision precision);

}  // namespace strahl
