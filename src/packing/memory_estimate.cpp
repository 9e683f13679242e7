// SPDX-License-Identifier: MIT
#include "packing/memory_estimate.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <variant>

#include "errors.h"
#include "kinds/entries.h"
#include "kinds/textures.h"
#include "packing/cl_layout.h"
#include "packing/pack_shapes.h"

namespace strahl {
namespace {

constexpr std::uint64_t bytes_of_ids = 8;                        // a primitive's id and part
constexpr std::uint64_t reals_of_normals = 9, reals_of_uvs = 6;  // a triangle's, corner by corner

std::uint64_t mebibytes(std::uint64_t bytes) { return (bytes + (1U << 20) - 1) >> 20; }

std::uint64_t largest_buffer(const MemoryNeed& need) { return std::max({need.geometry, need.shading, need.index}); }

bool is_shown(const Scene& scene, const std::string& attribute) {
  return std::any_of(scene.textures.begin(), scene.textures.end(),
                     [&](const Texture& texture) { return kinds::texture(texture).attribute == attribute; });
}

}  // namespace

MemoryNeed least_memory(const Scene& scene, const Features& features, Precision precision, int lanes) {
  const std::uint64_t real = precision == Precision::fp64 ? sizeof(double) : sizeof(float);
  const auto block = static_cast<std::uint64_t>(lanes);
  std::map<std::string, std::uint64_t> primitives;
  MemoryNeed need;
  const auto add_shape = [&](const Shape& shape) {
    if (!features.has("shapes", shape_kind(shape))) return;
    const auto count = static_cast<std::uint64_t>(primitive_count(shape));
    primitives[shape_kind(shape)] += count;
    const auto* mesh = std::get_if<Mesh>(&shape.geometry);
    if (mesh == nullptr) return;
    if (!mesh->normals.empty() && features.flag("SMOOTH_NORMALS")) need.shading += count * reals_of_normals * real;
    if (!mesh->uvs.empty() && features.flag("MESH_UVS")) need.shading += count * reals_of_uvs * real;
    if (!features.has("textures", "mesh_attribute")) return;
    for (const MeshAttribute& attribute : mesh->attributes)
      if (is_shown(scene, attribute.name)) need.shading += count * (attribute.is_of_faces() ? 3 : 9) * real;
  };
  const bool has_instances = features.flag("INSTANCES");
  for (const Shape& shape : scene.shapes) add_shape(shape);
  if (has_instances)
    for (const Group& group : scene.groups)
      for (const Shape& shape : group.shapes) add_shape(shape);
  std::set<const Texels*> images;
  const auto add_image = [&](const Texels& texels) {
    if (!images.insert(&texels).second) return;
    need.index += texels.words.size() * sizeof(std::int32_t);
    need.shading += texels.reals.size() * real;
  };
  std::set<const Texels*> pyramids;
  for (const Texture& texture : scene.textures) {
    const kinds::TextureFacts facts = kinds::texture(texture);
    if (facts.bitmap == nullptr || !features.has("textures", facts.entry)) continue;
    const Texels& texels = *facts.bitmap->texels;
    add_image(texels);
    if (!features.flag("TEXTURE_LOD") || facts.bitmap->filter == TextureFilter::nearest) continue;
    // A ninth of the texels at least, in halves: sizes are rounded down.
    if (pyramids.insert(&texels).second) need.index += texels.count() / 9 * (texels.is_grey ? 2 : 8);
  }
  for (const Light& light : scene.lights) {
    const auto* environment = std::get_if<EnvironmentLight>(&light.emitter);
    if (environment == nullptr || !features.has("lights", light_kind(light))) continue;
    add_image(*environment->texels);
    const std::size_t rows = static_cast<std::size_t>(environment->texels->height) - 1;
    const std::size_t cells = rows * static_cast<std::size_t>(environment->texels->width);
    need.index += (rows + cells) * layout::CHOICE_INTS * sizeof(std::int32_t);
  }
  if (features.flag("MEDIA"))
    for (const Medium& medium : scene.media)
      for (const Volume* volume : {&medium.sigma_t, &medium.albedo, &medium.emission})
        if (volume->grid) add_image(volume->grid->texels);
  for (const auto& [kind, count] : primitives) {
    const std::uint64_t slots = (count + block - 1) / block * block;
    need.geometry += slots * static_cast<std::uint64_t>(planes_of(kind)) * real;
    need.index += slots * bytes_of_ids;
  }
  const std::uint64_t instances = has_instances ? scene.instances.size() : 0;
  need.geometry += instances * layout::INSTANCE_REALS * real;
  need.index += instances * sizeof(std::int32_t);
  return need;
}

bool fits(const MemoryNeed& need, const DeviceInfo& device) {
  return need.total() <= device.global_memory && largest_buffer(need) <= device.max_allocation;
}

void require_memory(const MemoryNeed& need, const DeviceInfo& device, Precision precision) {
  if (fits(need, device)) return;
  throw NoDeviceError(fmt::format(
      "the scene takes at least {} MiB (geometry {}, normals and texture coordinates {}, tables and texels {}); {} has "
      "{}, {} MiB in one buffer. Choose {}{}, or simplify the meshes or images",
      mebibytes(need.total()), mebibytes(need.geometry), mebibytes(need.shading), mebibytes(need.index), device.text(),
      device.memory_text(), device.max_allocation >> 20, device.room_for(need.total()),
      precision == Precision::fp64 ? ", a --precision other than double, which takes half" : ""));
}

}  // namespace strahl
