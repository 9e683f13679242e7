// SPDX-License-Identifier: MIT
// What a rough boundary between dielectrics lets through, for the diffuse base under it.
#pragma once

#include <array>

#include "scene/model/materials.h"

namespace strahl::kinds {

struct RoughBoundary {
  /// Share of the light that goes through from outside at a cosine c: a polynomial, the highest power first, of
  /// ((1 + 2 spread) y - spread) / (y + spread), held to [0, 1]. That variable spreads what is near y = 0.
  std::array<double, 9> through{};
  double spread = 0.5;
  /// 0: y is c. Else the inside is optically thinner, and y the cosine beyond a smooth boundary, which near the
  /// critical angle and beyond it nears 0 in place of ending there: with q = 1 - (1 - c^2) / eta^2, its square, y^2 =
  /// (q + sqrt(q^2 + soft^2)) / 2.
  double soft = 0;
  /// Share of diffuse light from within that is reflected.
  double inner = 0;
};

/// eta: index of refraction inside over outside. Of equal arguments it is computed once.
[[nodiscard]] RoughBoundary rough_boundary(MicrofacetKind kind, double alpha, double eta);

/// What such a boundary of that eta lets through at a cosine, as the kernels compute it.
[[nodiscard]] double share_through(const RoughBoundary& boundary, double eta, double cosine);

/// Below 1 in single precision too: materials divide by what is left of it.
inline constexpr double largest_inner_reflectance = 1 - 0x1p-20;

/// The same of a smooth boundary, `inner` alone, as Mitsuba approximates it up to an eta of 3. Beyond, where that goes
/// on to 1 and above, it nears 1 as physics has it, up to largest_inner_reflectance.
[[nodiscard]] double smooth_inner_reflectance(double eta);

}  // namespace strahl::kinds
