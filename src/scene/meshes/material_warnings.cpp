// SPDX-License-Identifier: MIT
#include "scene/meshes/material_warnings.h"

#include <fmt/format.h>

#include "scene/meshes/mesh_source.h"

namespace strahl {

std::vector<Diagnostic> material_warnings(const MeshFile& file, const std::function<bool(const std::string&)>& is_given,
                                          const std::string& fate) {
  const MeshMaterial* first = nullptr;
  std::size_t undefined = 0, given = 0;
  for (const MeshMaterial& material : file.materials) {
    if (material.is_defined || material.where.file.empty()) continue;
    if (is_given(material.name)) {
      ++given;
      continue;
    }
    if (undefined++ == 0) first = &material;
  }
  std::vector<Diagnostic> all;
  if (undefined > 0 || given == 0) all = file.missing_libraries;
  if (first != nullptr)
    all.push_back({Severity::warning, first->where,
                   fmt::format("materials that no library defines: {}; {}; the first is {}", undefined, fate,
                               in_quotes(first->name))});
  all.insert(all.end(), file.library_problems.begin(), file.library_problems.end());
  return all;
}

}  // namespace strahl
