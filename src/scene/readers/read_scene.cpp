// SPDX-License-Identifier: MIT
// The children of <scene>, kind by kind, each in file order.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "scene/readers/mesh_import.h"
#include "scene/readers/read_material.h"
#include "scene/readers/readers.h"
#include "scene/readers/shape_reader.h"
#include "scene/xml/properties.h"

namespace strahl {

namespace {

void read_integrators(const std::vector<const XmlElement*>& elements, SceneBuilder& builder) {
  builder.scene.integrator.name = "auto";
  if (!elements.empty()) builder.scene.integrator = read_integrator(*elements.front(), builder);
  for (std::size_t i = 1; i < elements.size(); ++i)
    builder.diagnostics.error(elements[i]->where, "a scene has one <integrator>");
}

void read_one_shape(const XmlElement& element, SceneBuilder& builder) {
  if (is_group(element)) {
    group_index(element, builder);
  } else if (is_instance(element)) {
    read_instance(element, builder);
  } else {
    read_shape(element, builder, builder.scene.shapes);
  }
}

bool has_light(const Scene& scene) {
  return !scene.lights.empty() || std::ranges::any_of(scene.shapes, [](const Shape& shape) {
    return emits(shape, std::get_if<Mesh>(&shape.geometry));
  });
}

void report_lost_lights(const XmlElement& root, SceneBuilder& builder) {
  builder.scene.lost_emitters = static_cast<int>(builder.lost_emitters.size());
  if (builder.lost_emitters.empty() || has_light(builder.scene)) return;
  const std::set<std::string> types(builder.lost_emitters.begin(), builder.lost_emitters.end());
  builder.diagnostics.warning(
      root.where, fmt::format("no light is left: all {} emitters were left out ({}), so surfaces stay black; add an "
                              "<emitter> that strahl has, for example type=\"constant\"",
                              builder.lost_emitters.size(), fmt::join(types, ", ")));
}

/// Definitions wait for a <ref>; without an id nothing can refer to them.
void read_definitions(const std::vector<const XmlElement*>& elements, SceneBuilder& builder) {
  for (const XmlElement* element : elements) {
    if (element->attribute("id")) continue;
    builder.diagnostics.unknown(
        element->where, fmt::format("<scene> has no use for a <{}> without an id; it is ignored", element->tag));
  }
}

}  // namespace

namespace {

/// What files say of their meshes beyond what the scene asks for. Faults of what it asks for are told.
void drop_unused_attributes(SceneBuilder& builder) {
  Scene& scene = builder.scene;
  std::set<std::string> shown;
  for (const Texture& texture : scene.textures)
    if (const auto* attribute = std::get_if<AttributeTexture>(&texture.pattern)) shown.insert(attribute->name);
  const auto drop = [&](std::vector<Shape>& shapes) {
    for (Shape& shape : shapes)
      if (auto* mesh = std::get_if<Mesh>(&shape.geometry))
        std::erase_if(mesh->attributes, [&](const MeshAttribute& one) { return !shown.contains(one.name); });
  };
  drop(scene.shapes);
  for (Group& group : scene.groups) drop(group.shapes);
  for (const AttributeFault& one : builder.attribute_faults)
    if (shown.contains(one.name)) builder.diagnostics.append({one.fault});
}

}  // namespace

void read_scene(const XmlElement& root, SceneBuilder& builder) {
  Properties properties(root, builder.ids, builder.diagnostics);
  for (const XmlElement* bsdf : properties.objects("bsdf")) static_cast<void>(material_index(*bsdf, builder));
  const std::vector<const XmlElement*> shapes = properties.objects("shape");
  builder.scene.shapes.reserve(shapes.size());
  for (const XmlElement* shape : shapes) read_one_shape(*shape, builder);
  for (const XmlElement* emitter : properties.objects("emitter")) read_light(*emitter, builder);
  report_lost_lights(root, builder);
  read_sensors(properties.objects("sensor"), root, builder);
  read_integrators(properties.objects("integrator"), builder);
  for (const char* tag : {"texture", "spectrum", "rgb", "film", "sampler", "rfilter", "medium", "phase", "volume"})
    read_definitions(properties.objects(tag), builder);
  drop_unused_attributes(builder);
  properties.report_unknown();
}

}  // namespace strahl
