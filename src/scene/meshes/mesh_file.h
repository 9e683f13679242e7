// SPDX-License-Identifier: MIT
// Triangle meshes from OBJ with MTL, PLY and serialized files, read in double.
//
// A face that cannot be read, has fewer than 3 corners, no area, or edges that cross is skipped and counted in a
// warning. An index out of range, a number that is not finite where a face uses it, a truncated file and a mesh
// without triangles are errors. Where only some corners have a normal, the others get their triangle's; where only
// some have texture coordinates, the others get (0, 0). What no triangle uses is left out.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "errors.h"
#include "scene/meshes/mesh_material.h"
#include "scene/model/scene.h"

namespace strahl {

/// Whether whoever reads a mesh shades by the file's normals, or does so unless the file says to shade flat. Unused
/// ones need not be finite.
enum class MeshNormals { used, unused, as_file_says };

/// What makes an attribute unfit to be shown.
struct AttributeFault {
  std::string name;  ///< MeshAttribute::name.
  Diagnostic fault;
};

/// Faces before the first usemtl have a material without a name where others have one.
struct MeshFile {
  Mesh mesh;  ///< `parts` stays empty; part_of_triangle holds indices into `materials` (empty where there are none).
  std::vector<MeshMaterial> materials;
  std::vector<std::string> libraries;  ///< Paths of the MTL files that were read.
  bool face_normals = false;           ///< The file says to shade it flat (serialized).
  std::size_t skipped_faces = 0;
  std::vector<Diagnostic> warnings;              ///< Skipped faces (counted, with the first one's place), ...
  std::vector<Diagnostic> missing_libraries;     ///< Warnings, for material_warnings.h, as the next.
  std::vector<Diagnostic> library_problems;      ///< Of MTL files, errors too.
  std::vector<AttributeFault> attribute_faults;  ///< Of mesh.attributes, errors: for who shows one.
};

/// A readable mesh whose faces all have no area, or that has none; the last problem says so.
class EmptyMeshError : public SceneError {
 public:
  using SceneError::SceneError;
};

/// Gets the share of a file that is read, 0 to 1, rising; files of less than 1 MiB are not reported. May throw, which
/// ends the reading.
using MeshProgress = std::function<void(double share)>;

/// Reads by extension (.obj, .ply, .serialized: the first mesh; case-insensitive). Quads and n-gons are triangulated
/// (convex and concave planar polygons); vertices that differ in normal or uv index are split. Throws SceneError with
/// file:line.
[[nodiscard]] MeshFile read_mesh(const std::string& path, const MeshProgress& progress = {},
                                 MeshNormals normals = MeshNormals::used);
[[nodiscard]] MeshFile read_obj(const std::string& path, const MeshProgress& progress = {},
                                MeshNormals normals = MeshNormals::used);
[[nodiscard]] MeshFile read_ply(const std::string& path, const MeshProgress& progress = {},
                                MeshNormals normals = MeshNormals::used);
/// Mitsuba's format, which holds several meshes; `index` counts from 0.
[[nodiscard]] MeshFile read_serialized(const std::string& path, int index = 0, const MeshProgress& progress = {},
                                       MeshNormals normals = MeshNormals::used);

}  // namespace strahl
