// SPDX-License-Identifier: MIT
// Receives the items of an area light (cl/areas) and their areas from a shape's file (kinds/shapes.h).
#pragma once

#include <vector>

#include "kinds/extent.h"
#include "kinds/upload_frame.h"

namespace strahl::kinds {

class AreaItems {
 public:
  AreaItems(const UploadFrame& frame, bool is_flipped) : frame_(frame), is_flipped_(is_flipped) {}

  /// Spanned by two edges, of which `share` emits; u x v is the shape's normal.
  void flat(const Vec3& corner, const Vec3& u, const Vec3& v, double share) {
    put(frame_.point(corner));
    put(frame_.vector(u));
    put(frame_.vector(v));
    normals_.push_back((is_flipped_ ? -1.0 : 1.0) * normalized(cross(u, v)));
    put(normals_.back());
    weights_.push_back(share * length(cross(frame_.vector(u), frame_.vector(v))));
  }
  /// It faces all ways.
  void round(const std::vector<Vec3>& vectors, double area) {
    for (const Vec3& v : vectors) put(v);
    weights_.push_back(area);
  }
  void number(double x) { items_.push_back(x); }

  [[nodiscard]] const UploadFrame& frame() const { return frame_; }
  [[nodiscard]] bool is_flipped() const { return is_flipped_; }
  [[nodiscard]] std::vector<double>& items() { return items_; }
  [[nodiscard]] std::vector<double>& weights() { return weights_; }
  /// Around the items, in the world: emit adds to it.
  [[nodiscard]] Extent& extent() { return extent_; }
  /// Of the flat items, whose weights are the first ones.
  [[nodiscard]] const std::vector<Vec3>& normals() const { return normals_; }

 private:
  void put(const Vec3& v) { items_.insert(items_.end(), {v.x, v.y, v.z}); }

  const UploadFrame& frame_;
  bool is_flipped_;
  std::vector<double> items_, weights_;
  std::vector<Vec3> normals_;
  Extent extent_;
};

}  // namespace strahl::kinds
