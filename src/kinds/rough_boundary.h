// SPDX-License-Identifier: MIT
// What a rough boundary between dielectrics lets through, for the diffuse base under it.
#pragma once

#include <array>

#include "scene/model/materials.h"

namespace strahl::kinds {

struct RoughBoundary {
  /// Share of the light that goes through from outside at a cosine c: a polynomial of (2 c - 0.5) / (c + 0.5), the
  /// highest power first. That variable spreads shallow light.
  std::array<double, 9> through{};
  /// Share of diffuse light from within that is reflected.
  double inner = 0;
};

/// eta: index of refraction inside over outside. Of equal arguments it is computed once.
[[nodiscard]] RoughBoundary rough_boundary(MicrofacetKind kind, double alpha, double eta);

/// Below 1 in single precision too: materials divide by what is left of it.
inline constexpr double largest_inner_reflectance = 1 - 0x1p-20;

/// The same of a smooth boundary, `inner` alone, as Mitsuba approximates it up to an eta of 3. Beyond, where that goes
/// on to 1 and above, it nears 1 as physics has it, up to largest_inner_reflectance.
[[nodiscard]] double smooth_inner_reflectance(double eta);

}  // namespace strahl::kinds
