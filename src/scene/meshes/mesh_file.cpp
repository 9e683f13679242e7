// SPDX-License-Identifier: MIT
// Chooses the mesh reader by the file's extension.
#include "scene/meshes/mesh_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace strahl {

MeshFile read_mesh(const std::string& path, const MeshProgress& progress, MeshNormals normals) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (extension == ".obj") return read_obj(path, progress, normals);
  if (extension == ".ply") return read_ply(path, progress, normals);
  if (extension == ".serialized") return read_serialized(path, 0, progress, normals);
  throw SceneError({{Severity::error,
                     {path},
                     fmt::format("extension \"{}\" is no mesh format that is read; use .obj, "
                                 ".ply or .serialized",
                                 extension)}});
}

}  // namespace strahl
