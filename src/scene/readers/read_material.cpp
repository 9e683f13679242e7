// SPDX-License-Identifier: MIT
// Materials by name, each read once, and what stands for those that strahl does not have.
#include "scene/readers/read_material.h"

#include <fmt/format.h>

#include "kinds/materials.h"
#include "scene/readers/plugin_table.h"
#include "scene/readers/read_texture.h"

namespace strahl {

namespace {

const PluginTable<MaterialReader>& material_readers() {
  static const PluginTable<MaterialReader> table{
#define MATERIAL(name, reals, lobes) {#name, read_##name},
#include "../../../cl/materials/materials.def"
#undef MATERIAL
      {"twosided", read_twosided}, {"mask", read_mask},           {"null", read_null},
      {"blendbsdf", read_blend},   {"mixturebsdf", read_mixture}, {"normalmap", read_normalmap},
      {"bumpmap", read_bumpmap},   {"coating", read_coating},     {"polarizer", read_polarizer},
      {"circular", read_circular}, {"retarder", read_retarder}};
  return table;
}

/// A colour of light, or a texture of it. What is not known may call something else so, such as a vector.
bool gives_reflectance(const Properties& properties, const char* name) {
  const XmlElement* given = properties.peek(name);
  return given != nullptr && (given->tag == "rgb" || given->tag == "srgb" || given->tag == "spectrum" ||
                              given->tag == "blackbody" || given->tag == "texture");
}

/// Two-sided, since most of what is missing (rough glass, masks, radio materials) is seen from both sides.
Material substitute_for(Properties& properties, SceneBuilder& builder) {
  const std::string what = not_available("bsdf", properties.type(), types_of(material_readers()));
  const std::vector<const XmlElement*> nested = properties.objects("bsdf");
  if (properties.type() == "pplastic") {
    // The same layers with the polarization of light, which strahl does not follow; a few per cent apart.
    builder.diagnostics.unknown(properties.where(), what + "; \"roughplastic\" takes its place");
    return read_roughplastic(properties, builder);
  }
  properties.accept_all();
  if (!nested.empty()) {
    builder.diagnostics.unknown(properties.where(), what + "; the bsdf inside it takes its place");
    return material_of(*nested.front(), builder);
  }
  Material material;
  material.twosided = true;
  for (const char* name : {"reflectance", "diffuse_reflectance", "base_color"}) {
    if (!gives_reflectance(properties, name)) continue;
    builder.diagnostics.unknown(properties.where(),
                                fmt::format("{}; a two-sided diffuse one with its {} takes its place", what, name));
    material.bsdf = Diffuse{read_reflectance(properties, builder, name, {0.5, 0.5, 0.5})};
    return material;
  }
  builder.diagnostics.unknown(properties.where(),
                              what + "; a two-sided diffuse one of reflectance 0.5 takes its place");
  return material;
}

}  // namespace

Material material_of(const XmlElement& bsdf, SceneBuilder& builder) {
  const auto known = builder.materials.find(&bsdf);
  if (known != builder.materials.end()) return known->second;
  if (!builder.materials_being_read.insert(&bsdf).second) {
    builder.diagnostics.error(bsdf.where, fmt::format("bsdf \"{}\" contains itself", bsdf.text("id")));
    return {};
  }
  if (builder.materials_being_read.size() > std::size_t{deepest_material}) {
    builder.diagnostics.error(bsdf.where, fmt::format("bsdfs are nested deeper than {}", deepest_material));
    return {};
  }
  Properties properties(bsdf, builder.ids, builder.diagnostics);
  const MaterialReader* reader = find_plugin(material_readers(), properties.type());
  Material material = reader != nullptr ? (*reader)(properties, builder) : substitute_for(properties, builder);
  properties.report_unknown();
  material.id = properties.id();
  material.where = bsdf.where;
  builder.materials_being_read.erase(&bsdf);
  builder.materials.emplace(&bsdf, material);
  return material;
}

int add_material(const Material& material, SceneBuilder& builder) {
  builder.scene.materials.push_back(material);
  return static_cast<int>(builder.scene.materials.size()) - 1;
}

int material_index(const XmlElement& bsdf, SceneBuilder& builder) {
  const auto known = builder.material_indices.find(&bsdf);
  if (known != builder.material_indices.end()) return known->second;
  const int index = add_material(material_of(bsdf, builder), builder);
  builder.material_indices.emplace(&bsdf, index);
  return index;
}

}  // namespace strahl
