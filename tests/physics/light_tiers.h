// SPDX-License-Identifier: MIT
// Light as the kernels draw it, compiled for the host (physics/lights_*.cpp): cl/samplers, cl/lights, cl/areas and
// cl/integrators with every entry and feature active, so scenes are packed with RenderSettings::generic.
#pragma once

#include <array>
#include <cstdint>

#include "cl/host_kernels.h"

namespace strahl::test {

template <class Real>
using Triple = std::array<Real, 3>;

/// One light of those that are drawn from, as a vertex draws it.
template <class Real>
struct DrawnLight {
  int light = -1;         ///< Row of the light table.
  Triple<Real> towards;   ///< From the vertex.
  Real t_max;             ///< How far the way must be free, in units of `towards`.
  int id = -1;            ///< The flat primitive that the place is on; -1: none.
  Triple<Real> radiance;  ///< Of a delta light the irradiance across the direction.
  Real density;           ///< Per solid angle, of the light alone.
  bool is_delta = false;
};

/// Draws with that sample of pixel 0 at a vertex at `from`, which is `depth` surfaces behind the camera.
DrawnLight<float> drawn_light(const HostBuffers<float>& scene, std::uint32_t sample, int depth,
                              const Triple<float>& from);
DrawnLight<double> drawn_light(const HostBuffers<double>& scene, std::uint32_t sample, int depth,
                               const Triple<double>& from);

}  // namespace strahl::test
