// SPDX-License-Identifier: MIT
// Receives the items of an area light (cl/areas) and their areas from a shape's file (kinds/shapes.h).
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "kinds/extent.h"
#include "kinds/upload_frame.h"

namespace strahl::kinds {

/// Where the texture coordinates of places on an emitter come from.
enum class UvSource {
  none,        ///< It has no texture.
  parameters,  ///< The shape's own.
  mesh         ///< Those of the mesh where it has any.
};

class AreaItems {
 public:
  AreaItems(const UploadFrame& frame, bool is_flipped, UvSource uv_source)
      : frame_(frame), is_flipped_(is_flipped), uv_source_(uv_source) {}

  /// Spanned by two edges, of which `share` emits; u x v is the shape's normal.
  void flat(const Vec3& corner, const Vec3& u, const Vec3& v, double share) {
    put(frame_.point(corner));
    put(frame_.vector(u));
    put(frame_.vector(v));
    normals_.push_back((is_flipped_ ? -1.0 : 1.0) * normalized(cross(u, v)));
    put(normals_.back());
    weights_.push_back(share * length(cross(frame_.vector(u), frame_.vector(v))));
    if (uv_source_ != UvSource::none) uvs_.insert(uvs_.end(), {0, 0, 1, 0, 0, 1});
  }
  /// Texture coordinates of the last flat item's corner and of the ends of its edges, in place of its own.
  void map(const Vec2& corner, const Vec2& end_u, const Vec2& end_v) {
    if (uv_source_ != UvSource::mesh) return;
    uvs_.resize(uvs_.size() - 6);
    uvs_.insert(uvs_.end(),
                {corner.x, corner.y, end_u.x - corner.x, end_u.y - corner.y, end_v.x - corner.x, end_v.y - corner.y});
  }
  /// All items have the texture coordinates 0, 0.
  void unmap() { std::fill(uvs_.begin(), uvs_.end(), 0.0); }
  /// Of round items: what its file in cl/areas reads.
  void axes(const std::array<Vec3, 3>& frame) {
    if (uv_source_ == UvSource::none) return;
    for (const Vec3& axis : frame) uvs_.insert(uvs_.end(), {axis.x, axis.y, axis.z});
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
  /// LIGHT_UVS of cl/scene/layout.h; empty without a texture.
  [[nodiscard]] std::vector<double>& uvs() { return uvs_; }
  /// Around the items, in the world: emit adds to it.
  [[nodiscard]] Extent& extent() { return extent_; }
  /// Of the flat items, whose weights are the first ones.
  [[nodiscard]] const std::vector<Vec3>& normals() const { return normals_; }

 private:
  void put(const Vec3& v) { items_.insert(items_.end(), {v.x, v.y, v.z}); }

  const UploadFrame& frame_;
  bool is_flipped_;
  UvSource uv_source_;
  std::vector<double> items_, weights_, uvs_;
  std::vector<Vec3> normals_;
  Extent extent_;
};

}  // namespace strahl::kinds
