// SPDX-License-Identifier: MIT
// What can be asked of a scene: primitives of a shape, bounds of everything that is bounded.
#include "scene/model/scene.h"

#include "kinds/shapes.h"

namespace strahl {

namespace {

void extend_by(kinds::Extent& extent, const Shape& shape) {
  std::visit([&](const auto& geometry) { kinds::extend(extent, geometry); }, shape.geometry);
}

}  // namespace

int primitive_count(const Shape& shape) {
  return std::visit([](const auto& geometry) { return kinds::primitive_count(geometry); }, shape.geometry);
}

std::optional<Box> bounds(const Shape& shape) {
  kinds::Extent extent;
  extend_by(extent, shape);
  return extent.box();
}

Box bounds(const Box& box, const Transform& transform) {
  kinds::Extent extent;
  for (unsigned corner = 0; corner < 8; ++corner)
    extent.add(transform.point({(corner & 1U) != 0 ? box.max.x : box.min.x, (corner & 2U) != 0 ? box.max.y : box.min.y,
                                (corner & 4U) != 0 ? box.max.z : box.min.z}));
  return *extent.box();
}

std::optional<Box> bounds(const Group& group) {
  kinds::Extent all;
  for (const Shape& shape : group.shapes) extend_by(all, shape);
  return all.box();
}

std::optional<Box> bounds(const Scene& scene) {
  kinds::Extent all;
  for (const Shape& shape : scene.shapes) extend_by(all, shape);
  std::vector<std::optional<Box>> of_groups;
  for (const Group& group : scene.groups) of_groups.push_back(bounds(group));
  for (const Instance& instance : scene.instances)
    if (const auto& box = of_groups.at(static_cast<std::size_t>(instance.group))) {
      const Box placed = bounds(*box, instance.world_from_group);
      all.add(placed.min);
      all.add(placed.max);
    }
  return all.box();
}

}  // namespace strahl
