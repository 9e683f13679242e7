// SPDX-License-Identifier: MIT
#include "packing/shape_parts.h"

namespace strahl {
namespace {

const Mesh* mesh_with_parts(const Shape& shape) {
  const auto* mesh = std::get_if<Mesh>(&shape.geometry);
  return mesh && !mesh->parts.empty() ? mesh : nullptr;
}

bool is_cloud_of_lights(const Shape& shape) {
  return (shape.radiance || shape.exitance) && std::holds_alternative<SphereCloud>(shape.geometry);
}

}  // namespace

int part_count(const Shape& shape) {
  if (const Mesh* mesh = mesh_with_parts(shape)) return static_cast<int>(mesh->parts.size());
  return is_cloud_of_lights(shape) ? primitive_count(shape) : 1;
}

MeshPart look_of_part(const Shape& shape, int part) {
  if (const Mesh* mesh = mesh_with_parts(shape)) return mesh->parts[static_cast<std::size_t>(part)];
  return {shape.material, shape.radiance, shape.radiance_texture};
}

int part_of_primitive(const Shape& shape, int primitive) {
  if (const Mesh* mesh = mesh_with_parts(shape)) return mesh->part_of_triangle[static_cast<std::size_t>(primitive)];
  return is_cloud_of_lights(shape) ? primitive : 0;
}

PrimitivesOfParts::PrimitivesOfParts(const Shape& shape)
    : begins_(static_cast<std::size_t>(part_count(shape)) + 1, 0),
      primitives_(static_cast<std::size_t>(primitive_count(shape))) {
  const int count = primitive_count(shape);
  const auto part_of = [&](int i) { return static_cast<std::size_t>(part_of_primitive(shape, i)); };
  for (int i = 0; i < count; ++i) ++begins_[part_of(i) + 1];
  for (std::size_t part = 1; part < begins_.size(); ++part) begins_[part] += begins_[part - 1];
  std::vector<std::size_t> next(begins_.begin(), begins_.end() - 1);
  for (int i = 0; i < count; ++i) primitives_[next[part_of(i)]++] = i;
}

std::span<const int> PrimitivesOfParts::of(int part) const {
  const auto i = static_cast<std::size_t>(part);
  return std::span(primitives_).subspan(begins_[i], begins_[i + 1] - begins_[i]);
}

}  // namespace strahl
