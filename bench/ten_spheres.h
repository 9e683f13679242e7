// SPDX-License-Identifier: MIT
// strahl's program for ten spheres that only glow, beside a kernel written for just that (kernels/) and the generic
// one.
#pragma once

#include "opencl/device.h"
#include "scene/model/scene.h"
#include "settings/settings.h"

namespace strahl::bench {

struct TenSpheres {
  Precision precision = Precision::robust;
  int lanes = 1;
  std::vector<double> strahl, generic;  ///< Kernel seconds of a picture, a round each.
  std::vector<double> minimal_lanes, minimal_scalar;
  std::size_t pixels = 0, scalar_differs = 0;  ///< Where the scalar loop has another colour than strahl.

  /// Of those with the tier's arithmetic: the scalar loop has that of fast.
  [[nodiscard]] bool is_scalar_faster() const;
  [[nodiscard]] const std::vector<double>& minimal() const {
    return is_scalar_faster() ? minimal_scalar : minimal_lanes;
  }
};

/// Ten spheres that glow; one ray through the middle of each pixel.
[[nodiscard]] Scene ten_glowing_spheres(int side);

/// In turns. Throws Error where the kernel in lanes has not the bits of strahl's picture, or the scalar one another
/// colour in more than one pixel in a hundred.
[[nodiscard]] TenSpheres time_ten_spheres(const Device& device, Precision precision, int side, int rounds);

}  // namespace strahl::bench
