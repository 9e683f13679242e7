// SPDX-License-Identifier: MIT
#include "scene/readers/mesh_import.h"

#include <algorithm>
#include <filesystem>

#include "scene/readers/mtl_materials.h"
#include "scene/xml/parse_value.h"

namespace strahl {

bool emits(const Shape& shape, const Mesh* mesh) {
  return shape.radiance || shape.exitance ||
         (mesh != nullptr &&
          std::ranges::any_of(mesh->parts, [](const MeshPart& part) { return part.radiance.has_value(); }));
}

bool has_stand_in(const Shape& shape) { return shape.material != 0; }

void add_mesh_materials(MeshFile& file, const GivenMaterials& given, const Shape& shape, Scene& scene,
                        ImageFiles& images, Diagnostics& diagnostics) {
  Mesh& mesh = file.mesh;
  if (file.materials.empty() || mesh.part_of_triangle.empty() || (given.of_shape && given.by_name.empty())) {
    mesh.part_of_triangle.clear();
    return;
  }
  for (const MeshMaterial& from : file.materials) {
    const auto named = given.by_name.find(from.name);
    const bool is_named = named != given.by_name.end(), is_of_file = !is_named && !given.of_shape;
    MeshPart part{is_named ? named->second : shape.material, shape.radiance, shape.radiance_texture};
    if (is_of_file && (from.is_defined || !has_stand_in(shape)))
      part.material = added_material(from, shape, scene, images, diagnostics);
    if (is_of_file && !shape.radiance && !shape.exitance) part.radiance = from.radiance;
    mesh.parts.push_back(part);
  }
  const bool has_plain =
      std::any_of(mesh.part_of_triangle.begin(), mesh.part_of_triangle.end(), [](int p) { return p < 0; });
  if (!has_plain) return;
  mesh.parts.push_back({shape.material, shape.radiance, shape.radiance_texture});
  for (int& part : mesh.part_of_triangle)
    if (part < 0) part = static_cast<int>(mesh.parts.size()) - 1;
}

MeshProgress progress_of(const std::string& path, const LoadProgress& progress) {
  if (!progress) return {};
  return [path, &progress](double share) { progress(path, share); };
}

std::string lower_case_extension(const std::string& path) {
  return lower_case(std::filesystem::path(path).extension().string());
}

void flip_tex_coords(Mesh& mesh) {
  for (Vec2& uv : mesh.uvs) uv.y = 1 - uv.y;
}

}  // namespace strahl
