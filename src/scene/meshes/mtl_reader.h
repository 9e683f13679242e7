// SPDX-License-Identifier: MIT
// Wavefront MTL: the Kd and Ke of each material.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "scene/meshes/mesh_file.h"

namespace strahl {

/// Materials of one or several MTL files by name. The first definition of a name counts.
struct MtlLibrary {
  std::map<std::string, MeshMaterial> materials;
  std::vector<Diagnostic> diagnostics;
  std::vector<std::string> files;  ///< Paths, in the order in which they were read.
};

/// Adds the materials of a file. What is wrong with it goes to the diagnostics; throws SceneError only where the file
/// cannot be read at all.
void read_mtl(const std::string& path, MtlLibrary& library);

}  // namespace strahl
