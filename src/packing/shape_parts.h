// SPDX-License-Identifier: MIT
// Parts of a shape: what has a look, and a light if it emits, of its own. Rows of the part table (cl/scene/layout.h).
#pragma once

#include "scene/model/scene.h"

namespace strahl {

/// A mesh's parts, where it has any. Of a cloud that emits every sphere: each is a light. Else 1.
[[nodiscard]] int part_count(const Shape& shape);
[[nodiscard]] MeshPart look_of_part(const Shape& shape, int part);
[[nodiscard]] int part_of_primitive(const Shape& shape, int primitive);

}  // namespace strahl
