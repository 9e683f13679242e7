// SPDX-License-Identifier: MIT
// Parts of a shape: what has a look, and a light if it emits, of its own. Rows of the part table (cl/scene/layout.h).
#pragma once

#include <span>
#include <vector>

#include "scene/model/scene.h"

namespace strahl {

/// A mesh's parts, where it has any. Of a cloud that emits every sphere: each is a light. Else 1.
[[nodiscard]] int part_count(const Shape& shape);
[[nodiscard]] MeshPart look_of_part(const Shape& shape, int part);
[[nodiscard]] int part_of_primitive(const Shape& shape, int primitive);

/// The primitives of each part, sorted once for all of them.
class PrimitivesOfParts {
 public:
  explicit PrimitivesOfParts(const Shape& shape);
  /// In the shape's order.
  [[nodiscard]] std::span<const int> of(int part) const;

 private:
  std::vector<std::size_t> begins_;  ///< Of each part in primitives_, and the end.
  std::vector<int> primitives_;      ///< Part by part.
};

}  // namespace strahl
