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

}  // namespace strahl
