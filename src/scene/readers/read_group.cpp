// SPDX-License-Identifier: MIT
// <shape type="shapegroup">, shapes in a frame of their own, and <shape type="instance">, which places such a group.
#include <fmt/format.h>

#include "scene/readers/shape_reader.h"

namespace strahl {

bool is_group(const XmlElement& shape) { return shape.text("type") == "shapegroup"; }
bool is_instance(const XmlElement& shape) { return shape.text("type") == "instance"; }

std::optional<int> group_index(const XmlElement& element, SceneBuilder& builder) {
  if (const auto known = builder.group_indices.find(&element); known != builder.group_indices.end())
    return known->second;
  Properties properties(element, builder.ids, builder.diagnostics);
  Group group;
  group.id = properties.id();
  group.where = element.where;
  const std::vector<const XmlElement*> shapes = properties.objects("shape");
  builder.is_in_group = true;
  for (const XmlElement* shape : shapes) {
    if (is_group(*shape) || is_instance(*shape)) {
      builder.diagnostics.error(shape->where,
                                "groups cannot be nested: a shapegroup holds neither shapegroups nor "
                                "instances; give it the shapes themselves");
    } else {
      read_shape(*shape, builder, group.shapes);
    }
  }
  builder.is_in_group = false;
  properties.accept({silhouette_weight});
  if (shapes.empty()) builder.diagnostics.error(element.where, fmt::format("{} holds no <shape>", properties.title()));
  properties.report_unknown();
  if (group.shapes.empty() && !builder.diagnostics.has_errors()) {
    builder.diagnostics.warning(element.where, fmt::format("all shapes of {} are left out, so it is left out with its "
                                                           "instances",
                                                           properties.title()));
    builder.group_indices[&element] = std::nullopt;
    return std::nullopt;
  }
  const int index = static_cast<int>(builder.scene.groups.size());
  builder.scene.groups.push_back(std::move(group));
  builder.group_indices[&element] = index;
  return index;
}

void read_instance(const XmlElement& element, SceneBuilder& builder) {
  Properties properties(element, builder.ids, builder.diagnostics);
  Instance instance;
  instance.id = properties.id();
  instance.where = element.where;
  instance.world_from_group = properties.transform("to_world").value_or(Transform{});
  properties.accept({silhouette_weight});
  const std::vector<const XmlElement*> groups = properties.objects("shape");
  if (groups.size() != 1) {
    builder.diagnostics.error(element.where,
                              fmt::format("{} needs one <shape type=\"shapegroup\">, or a <ref> to one; it has {}",
                                          properties.title(), groups.size()));
  } else if (!is_group(*groups[0])) {
    builder.diagnostics.error(element.where,
                              fmt::format("{} places a <shape type=\"shapegroup\">, not a <shape type=\"{}\">",
                                          properties.title(), groups[0]->text("type")));
  } else {
    if (const std::optional<int> group = group_index(*groups[0], builder)) {
      instance.group = *group;
      builder.scene.instances.push_back(std::move(instance));
    }
  }
  properties.report_unknown();
}

}  // namespace strahl
