// SPDX-License-Identifier: MIT
// Lights together: what bounds where they are and which way they shine.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "kinds/light_reach.h"
#include "scene/model/vec.h"

namespace strahl {

struct LightCluster {
  double strength = 0;  ///< Intensities in sum; of far lights irradiances.
  bool is_far = false;
  std::optional<Box> box;
  Vec3 axis{0, 0, 1};
  double spread = 0, cutoff = 0;  ///< As a LightReach has them.

  [[nodiscard]] static LightCluster of(const LightReach& light);
  /// Of lights that are all far or all near.
  void include(const LightCluster& other);

  /// What grows with the chance that its lights are asked in vain; the box's surface by half its perimeter where it is
  /// flat.
  [[nodiscard]] double cost() const;
  /// LIGHT_CHILD_... of cl/scene/layout.h; least_radius: of its ball, so that nothing divides by zero.
  [[nodiscard]] std::vector<double> reals(double least_radius) const;
};

/// Far below the distance of any point that is lit by one of several lights apart.
[[nodiscard]] double least_light_radius(std::span<const LightReach> lights);

}  // namespace strahl
