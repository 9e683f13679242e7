// SPDX-License-Identifier: MIT
// What stands behind a map of an MTL file: options, then a file's name, which may hold blanks.
#pragma once

#include <string>

#include "scene/meshes/mesh_material.h"
#include "scene/meshes/text_cursor.h"

namespace strahl {

/// At the first word behind "map_Kd" or another map. The file is sought beside the MTL file, with slashes of either
/// direction; empty where the line names none. Options without a counterpart are passed over.
[[nodiscard]] MeshTexture read_mtl_map(TextCursor& cursor, const std::string& mtl_path);

}  // namespace strahl
