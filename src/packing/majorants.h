// SPDX-License-Identifier: MIT
// The cells of a medium that varies, each with the largest sigma_t within it (cl/media/march_lanes.h).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kinds/upload_frame.h"
#include "scene/model/volume.h"

namespace strahl {

struct Majorants {
  std::vector<double> reals;  ///< cl/media/media_layout.h, MAJORANT_REAL_COUNT.
  std::vector<float> most;    ///< Per unit of length of the frame, rounded up; x first, then y, then z.
  std::array<std::int32_t, 3> size{};
  double cell = 0;  ///< The longest way along a side of a cell, in the frame.
};

/// sigma_t: a grid.
[[nodiscard]] Majorants majorants_of(const Volume& sigma_t, const UploadFrame& frame);

/// The 12 reals with which kernels take places of the upload frame to the volume's box in units of `size` a side, about
/// the point `middle` of the unit cube: that point, then three rows.
[[nodiscard]] std::vector<double> box_frame(const Transform& world_from_cube, const UploadFrame& frame,
                                            const Vec3& size, const Vec3& middle);

}  // namespace strahl
