// SPDX-License-Identifier: MIT
// Mesh files of any size: a rolling surface over a square grid, in every format and shape that the loaders are timed
// on.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace strahl::bench {

/// What write_mesh_file() knows, in the order in which it is timed:
/// obj, obj-normals (shared by the corners of a vertex), obj-corners (a normal each face, so that every corner is a
/// vertex of its own), obj-quads, ply-ascii, ply (binary), ply-normals, ply-big (the other byte order), serialized
/// (Mitsuba's).
[[nodiscard]] const std::vector<std::string>& mesh_kinds();

/// ".obj" of "obj-corners".
[[nodiscard]] std::string extension_of(const std::string& kind);

/// At least `triangles` of them: two for each cell of a square grid. Throws UsageError where the kind is unknown.
void write_mesh_file(const std::string& path, const std::string& kind, std::uint64_t triangles);

}  // namespace strahl::bench
