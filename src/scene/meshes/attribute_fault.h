// SPDX-License-Identifier: MIT
// Attributes that are not made of finite numbers.
#pragma once

#include "scene/meshes/mesh_file.h"
#include "scene/meshes/mesh_source.h"

namespace strahl {

[[nodiscard]] bool is_finite(const MeshAttribute& attribute);

/// at: the first place of a number that is not finite.
[[nodiscard]] AttributeFault fault_of(const MeshAttribute& attribute, const char* at, const MeshSource& source);

}  // namespace strahl
