// SPDX-License-Identifier: MIT
// The same scene in other units and elsewhere, and by more light, in every tier: pictures that would all be the same
// with exact numbers, but for the light's own factor. And by a lamp that is far or small, in every tier: against the
// same in the reference's. One at a time: what scales together may hide what each does.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "image/image.h"
#include "opencl/device.h"
#include "scene/model/scene.h"
#include "settings/settings.h"

namespace strahl {

/// Every length times `scale`, then every place moved by `offset` along each axis; or one of the others.
struct Stress {
  double scale = 1;
  double offset = 0;
  double light = 1;  ///< Every emitter so many times as bright; the picture is divided by it.
  double far = 0;    ///< Not 0: a lamp so many extents of the scene behind the camera.
  double lamp = 0;   ///< Not 0: a lamp near the camera, whose radius is that share of its distance.

  [[nodiscard]] std::string text() const;  ///< "scale 1e-06", "offset 1e+07"; "as it is".
};

/// 10^-6 ... 10^6 about the origin, then size 1 at offsets up to 10^7, then light, far objects and lamps.
[[nodiscard]] const std::vector<Stress>& all_stresses();

struct StressCell {
  Image picture;
  double rmse = 0;  ///< To the reference: the scene as it is; of `far` and `lamp` the same stress.
};

struct StressStudy {
  Precision reference = Precision::fp64;  ///< What references are rendered in; robust where the device has no fp64.
  std::vector<Precision> tiers;           ///< Every one that the device has, whatever its canary says.
  std::vector<std::vector<StressCell>> cells;  ///< By tier, then as all_stresses.
};

/// Called after each of `total` pictures.
using StressProgress = std::function<void(int done, int total)>;

/// Renders the scene as it samples itself; the same seed everywhere.
[[nodiscard]] StressStudy study_stress(const Device& device, const Scene& scene, const StressProgress& progress = {});

/// A row a tier, a column a stress, the RMSE below each picture.
[[nodiscard]] Image stress_sheet(const StressStudy& study);

}  // namespace strahl
