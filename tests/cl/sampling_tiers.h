// SPDX-License-Identifier: MIT
// cl/math/sampling_lanes.h, cl/samplers and cl/areas of both tiers on the host, side by side; compiled in
// sampling_f32.cpp and sampling_f64.cpp.
#pragma once

#include <array>
#include <cstdint>

namespace strahl::test {

using Pair = std::array<std::uint32_t, 2>;

/// The samplers' points; the same in both tiers.
Pair sobol_pair(std::uint32_t pixel, std::uint32_t sample, std::uint32_t set, std::uint32_t seed);
/// Where the film keeps one sum.
Pair sobol_single_pair(std::uint32_t pixel, std::uint32_t sample, std::uint32_t set, std::uint32_t seed);
Pair independent_pair(std::uint32_t pixel, std::uint32_t sample, std::uint32_t set, std::uint32_t seed);

template <class Real>
using Triple = std::array<Real, 3>;

template <class Real>
struct DrawnPoint {
  Triple<Real> position, normal;
  Real density;
};

enum class AreaKind { triangle, parallelogram, disk, sphere, cylinder };

/// One tier's maps of the unit square.
template <class Real>
struct Maps {
  static Real between(std::uint32_t bits);
  static Triple<Real> disk(Real u, Real v);  ///< z = 0.
  static Triple<Real> cosine_hemisphere(Real u, Real v);
  static Triple<Real> sphere(Real u, Real v);
  static Triple<Real> triangle(Real u, Real v);  ///< All three weights.
  static std::array<Triple<Real>, 2> frame(const Triple<Real>& n);
  /// area: the reals of a light (cl/scene/layout.h, AREA_...), one item.
  static DrawnPoint<Real> point(AreaKind kind, const Real* area, const Triple<Real>& from, Real u, Real v);
  static Real density(AreaKind kind, const Real* area, const Triple<Real>& from, const Triple<Real>& towards,
                      const Triple<Real>& normal);
};

}  // namespace strahl::test
