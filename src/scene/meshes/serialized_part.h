// SPDX-License-Identifier: MIT
// Where the meshes of a `.serialized` file stand in it.
#pragma once

#include <cstdint>
#include <string>

namespace strahl {

struct SerializedPart {
  std::uint64_t begin = 0, end = 0;  ///< Bytes of the file: the mesh's own header and its compressed stream.
  int version = 4;                   ///< 3 or 4, of the whole file.
};

/// Throws SceneError where the file cannot be read, is of another kind or version, or has no mesh of that index.
[[nodiscard]] SerializedPart find_serialized_part(const std::string& path, int index);

}  // namespace strahl
