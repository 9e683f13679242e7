// SPDX-License-Identifier: MIT
// What all shapes share: id, to_world, flip_normals, a bsdf, an area emitter.
#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "scene/readers/mesh_import.h"
#include "scene/readers/plugin_table.h"
#include "scene/readers/read_material.h"
#include "scene/readers/read_medium.h"
#include "scene/readers/read_texture.h"
#include "scene/readers/readers.h"
#include "scene/readers/shape_reader.h"
#include "scene/unseen.h"

namespace strahl {

namespace {

using ShapeReader = Geometry (*)(ShapeInput&);

template <class S>
Geometry read_as(ShapeInput& input) {
  return read_geometry(input, S{});
}

const PluginTable<ShapeReader>& shape_readers() {
  static const PluginTable<ShapeReader> table = [] {
    PluginTable<ShapeReader> readers;
    const auto add = [&](const char* types, ShapeReader reader) {
      std::istringstream words(types);
      for (std::string type; words >> type;) readers.emplace_back(type, reader);
    };
#define SHAPE_KIND(S, kind, area, types) add(types, read_as<S>);
#include "kinds/shapes.def"
#undef SHAPE_KIND
    return readers;
  }();
  return table;
}

std::vector<std::string> shape_types() {
  std::vector<std::string> types = types_of(shape_readers());
  types.insert(types.end(), {"shapegroup", "instance"});
  return types;
}

void read_area_emitter(const XmlElement& element, Shape& shape, SceneBuilder& builder) {
  Properties properties(element, builder.ids, builder.diagnostics);
  const bool is_beam = properties.type() == "directionalarea";
  static_cast<void>(properties.objects("medium"));  // The boundaries of media define what surrounds it.
  if (properties.type() != "area" && !is_beam) {
    builder.diagnostics.unknown(
        element.where, fmt::format("{} cannot be part of a shape{}; the shape does not emit", properties.title(),
                                   did_you_mean(properties.type(), {"area", "directionalarea"})));
    builder.lost_emitters.emplace_back(properties.type());
    return;
  }
  const Emission radiance = read_emission(properties, builder, "radiance");
  (is_beam ? shape.exitance : shape.radiance) = radiance.color;
  shape.radiance_texture = radiance.texture;
  shape.radiance_where = element.where;
  shape.sampling_weight = read_sampling_weight(properties);
  properties.report_unknown();
}

/// The first of the objects; more are reported.
const XmlElement* only_one(const std::vector<NamedObject>& objects, const Properties& properties) {
  for (std::size_t i = 1; i < objects.size(); ++i) {
    properties.diagnostics().error(
        objects[i].where, fmt::format("{} has more than one <{}>", properties.title(), objects[i].object->tag));
  }
  return objects.empty() ? nullptr : objects.front().object;
}

/// The last of them, as 0.x has it; the others are named.
const XmlElement* last_bsdf(const std::vector<NamedObject>& bsdfs, const Properties& properties) {
  for (std::size_t i = 0; i + 1 < bsdfs.size(); ++i)
    properties.diagnostics().warning(bsdfs[i].where, fmt::format("{} has more than one <bsdf>; the last counts, at {}",
                                                                 properties.title(), bsdfs.back().where.text()));
  return bsdfs.empty() ? nullptr : bsdfs.back().object;
}

/// Of an OBJ of 0.x, as its upgrade says.
std::vector<NamedMaterial> read_named_materials(Properties& properties, SceneBuilder& builder) {
  std::vector<NamedMaterial> named;
  if (!properties.has_old_rule("has_named_bsdfs")) return named;
  for (const NamedObject& bsdf : properties.named_objects("bsdf"))
    named.push_back({bsdf.name, material_index(*bsdf.object, builder), bsdf.where});
  return named;
}

Material black() {
  Material material;
  material.bsdf = Diffuse{{{0, 0, 0}}};
  return material;
}

/// `known`: its index, once it is among the scene's.
int index_of(const Material& material, std::optional<int>& known, SceneBuilder& builder) {
  if (!known) known = add_material(material, builder);
  return *known;
}

}  // namespace

void read_shape(const XmlElement& element, SceneBuilder& builder, std::vector<Shape>& shapes) {
  Properties properties(element, builder.ids, builder.diagnostics);
  const ShapeReader* reader = find_plugin(shape_readers(), properties.type());
  if (reader == nullptr) {
    builder.diagnostics.unknown(
        element.where, fmt::format("{}; it is left out", not_available("shape", properties.type(), shape_types())));
    const std::vector<const XmlElement*> emitters = properties.objects("emitter");
    if (!emitters.empty()) builder.lost_emitters.emplace_back("area");
    builder.emitters_of_shapes.insert(emitters.begin(), emitters.end());
    return;
  }
  Shape shape;
  shape.id = properties.id();
  shape.where = element.where;
  shape.flip_normals = properties.boolean("flip_normals").value_or(false);
  shape.priority = properties.integer("priority");
  properties.accept({silhouette_weight});
  std::vector<NamedMaterial> named_materials = read_named_materials(properties, builder);
  const bool takes_last = properties.has_old_rule("takes_last_bsdf");  // Of 0.x.
  const std::vector<NamedObject> bsdfs = properties.placed_objects("bsdf");
  const XmlElement* bsdf = takes_last ? last_bsdf(bsdfs, properties) : only_one(bsdfs, properties);
  const XmlElement* emitter = only_one(properties.placed_objects("emitter"), properties);
  if (bsdf != nullptr) shape.material = material_index(*bsdf, builder);
  if (emitter != nullptr) builder.emitters_of_shapes.insert(emitter);
  if (emitter != nullptr) read_area_emitter(*emitter, shape, builder);
  shape.media = read_boundary(properties, builder);
  const bool is_open = properties.has_old_rule("is_open_without_bsdf") && shape.media;  // Of 0.x.
  if (bsdf == nullptr && (shape.radiance || shape.exitance))
    shape.material = index_of(black(), builder.black_material, builder);  // As in Mitsuba it reflects nothing.
  else if (bsdf == nullptr && is_open)
    shape.material = index_of(null_material(), builder.open_material, builder);
  const Transform to_world = properties.transform("to_world").value_or(Transform{});
  ShapeInput input{properties, to_world, shape, bsdf != nullptr, builder, std::move(named_materials)};
  shape.geometry = (*reader)(input);
  if (input.is_left_out && (shape.radiance || shape.exitance)) builder.lost_emitters.emplace_back("area");
  if (input.is_left_out) return properties.report_unknown();
  if (shape.priority && !is_ranked(shape, builder.scene))
    builder.diagnostics.unknown(properties.where("priority"),
                                "\"priority\" has no effect here: it ranks shapes of bsdf dielectric and "
                                "roughdielectric, and boundaries of media of bsdf null, mask and thindielectric");
  properties.report_unknown();
  shapes.push_back(std::move(shape));
}

}  // namespace strahl
