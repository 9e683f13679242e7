// SPDX-License-Identifier: MIT
// MTL materials are two-sided: OBJ files know no sidedness, and many do not care for their winding.
#include "scene/readers/mesh_import.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "image/file_bytes.h"
#include "kinds/textures.h"
#include "scene/xml/color_value.h"

namespace strahl {

namespace {

/// Index of the texture of a map_Kd, times Kd; -1 where its file cannot be read, which is warned of.
int added_texture(const MeshTexture& from, const Rgb& scale, Scene& scene, ImageFiles& images,
                  Diagnostics& diagnostics) {
  const std::string obstacle = unreadable_because(from.file);
  if (!obstacle.empty()) {
    diagnostics.warning(from.where, fmt::format("cannot read \"{}\": {}; Kd stands", from.file, obstacle));
    return -1;
  }
  Bitmap bitmap;
  bitmap.texels = images.read(from.file, from.where, diagnostics);
  if (!bitmap.texels) return -1;
  bitmap.scale = scale;
  bitmap.wrap = from.is_clamped ? TextureWrap::clamp : TextureWrap::repeat;
  // v counts from the bottom in the file and from the top in the mesh.
  bitmap.to_uv = {from.scale.x, 0, from.offset.x, 0, from.scale.y, 1 - from.scale.y - from.offset.y};
  bitmap.mean = kinds::mean_of(*bitmap.texels, bitmap.curve);
  scene.textures.push_back({"", bitmap, from.where});
  return static_cast<int>(scene.textures.size()) - 1;
}

int added_material(const MeshMaterial& from, const Shape& shape, Scene& scene, ImageFiles& images,
                   Diagnostics& diagnostics) {
  Material material;
  material.id = from.name;
  Reflectance reflectance{
      clamped_reflectance(from.reflectance, shape.where, fmt::format("Kd of {}", from.name), diagnostics)};
  if (from.reflectance_map)
    reflectance.texture = added_texture(*from.reflectance_map, reflectance.color, scene, images, diagnostics);
  material.bsdf = Diffuse{reflectance};
  material.twosided = true;
  material.where = shape.where;
  scene.materials.push_back(material);
  return static_cast<int>(scene.materials.size()) - 1;
}

}  // namespace

void add_mesh_materials(MeshFile& file, bool has_material, const Shape& shape, Scene& scene, ImageFiles& images,
                        Diagnostics& diagnostics) {
  Mesh& mesh = file.mesh;
  if (file.materials.empty() || mesh.part_of_triangle.empty() || (has_material && shape.radiance)) {
    mesh.part_of_triangle.clear();
    return;
  }
  for (const MeshMaterial& from : file.materials) {
    MeshPart part;
    part.material = has_material ? shape.material : added_material(from, shape, scene, images, diagnostics);
    part.radiance = shape.radiance ? shape.radiance : from.radiance;
    mesh.parts.push_back(part);
  }
  const bool has_plain =
      std::any_of(mesh.part_of_triangle.begin(), mesh.part_of_triangle.end(), [](int p) { return p < 0; });
  if (!has_plain) return;
  mesh.parts.push_back({shape.material, shape.radiance});
  for (int& part : mesh.part_of_triangle)
    if (part < 0) part = static_cast<int>(mesh.parts.size()) - 1;
}

MeshProgress progress_of(const std::string& path, const LoadProgress& progress) {
  if (!progress) return {};
  return [path, &progress](double share) { progress(path, share); };
}

std::string lower_case_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

void flip_tex_coords(Mesh& mesh) {
  for (Vec2& uv : mesh.uvs) uv.y = 1 - uv.y;
}

}  // namespace strahl
