// SPDX-License-Identifier: MIT
// What there is to say of a mesh file's materials to those who use them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scene/meshes/mesh_file.h"

namespace strahl {

/// Of MTL files and what they lack, errors too. Nothing is said of materials that something else is given for, by name,
/// nor of missing libraries where that is so of all that no library defines. fate: what the others become.
[[nodiscard]] std::vector<Diagnostic> material_warnings(
    const MeshFile& file, const std::function<bool(const std::string&)>& is_given = [](const auto&) { return false; },
    const std::string& fate = "they become the default diffuse");

}  // namespace strahl
