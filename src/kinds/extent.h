// SPDX-License-Identifier: MIT
// The axis-aligned box that shapes take up together.
#pragma once

#include <algorithm>
#include <optional>

#include "scene/model/scene.h"

namespace strahl::kinds {

class Extent {
 public:
  /// p - half ... p + half.
  void add(const Vec3& p, const Vec3& half = {}) {
    if (!box_) box_ = Box{p - half, p + half};
    box_->min = {std::min(box_->min.x, p.x - half.x), std::min(box_->min.y, p.y - half.y),
                 std::min(box_->min.z, p.z - half.z)};
    box_->max = {std::max(box_->max.x, p.x + half.x), std::max(box_->max.y, p.y + half.y),
                 std::max(box_->max.z, p.z + half.z)};
  }

  /// None: nothing bounded was added.
  [[nodiscard]] const std::optional<Box>& box() const { return box_; }

 private:
  std::optional<Box> box_;
};

}  // namespace strahl::kinds
