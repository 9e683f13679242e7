// SPDX-License-Identifier: MIT
// A workload for every kind of primitive, by brute force: what a test of one costs where no tree spares any.
#pragma once

#include "bench/workload.h"

namespace strahl::bench {

/// Of cl/shapes/shapes.def; a parallelogram is called "rectangle".
[[nodiscard]] const std::vector<std::string>& primitive_names();

/// 64 primitives (16 planes) of ordinary size about the origin, and rays towards them from around: of ordinary
/// conditioning, so that every tier must answer right. Throws UsageError for an unknown name.
[[nodiscard]] Workload primitive_workload(const std::string& name, std::size_t rays);

}  // namespace strahl::bench
