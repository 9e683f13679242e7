// SPDX-License-Identifier: MIT
// Whether kernels can read a packed scene: every offset in it leads to as many numbers as are read there, every number
// of a row is that of a row, every chain of rows ends, and every tree fits its stack. Kernels check nothing of this; a
// device that is led astray crashes, or worse.
#pragma once

#include <string>

#include "packing/pack.h"
#include "packing/packed_scene.h"

namespace strahl {

/// What is wrong, in a few words; empty: nothing. scene, features, options: what it was packed from.
template <typename Real>
[[nodiscard]] std::string fault_of_packed(const PackedScene<Real>& packed, const Scene& scene, const Features& features,
                                          const PackOptions& options);

/// Throws std::logic_error where there is a fault.
template <typename Real>
void check_packed(const PackedScene<Real>& packed, const Scene& scene, const Features& features,
                  const PackOptions& options);

}  // namespace strahl
