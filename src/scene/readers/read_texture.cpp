// SPDX-License-Identifier: MIT
// Textures by name, each read once.
#include "scene/readers/read_texture.h"

#include <fmt/format.h>

#include <utility>

#include "kinds/textures.h"
#include "scene/readers/plugin_table.h"
#include "scene/xml/typed_spectrum.h"

namespace strahl {

namespace {

const PluginTable<TextureReader>& texture_readers() {
  static const PluginTable<TextureReader> table{
#define TEXTURE(name) {#name, read_##name},
#include "../../../cl/textures/textures.def"
#undef TEXTURE
  };
  return table;
}

double mean_of(const Rgb& c) { return (c.r + c.g + c.b) / 3; }

int texture_index(const XmlElement& element, TextureReader reader, SceneBuilder& builder, TextureUse what) {
  const bool is_one_number = what == TextureUse::number || what == TextureUse::quantity;
  const bool swaps_colours = is_one_number && element.text("type") == "checkerboard";
  if (is_one_number && !swaps_colours) what = what == TextureUse::number ? TextureUse::colour : TextureUse::value;
  const bool is_unbounded = what != TextureUse::colour && what != TextureUse::number;
  const auto known = builder.texture_indices.find({&element, what});
  if (known != builder.texture_indices.end()) return known->second;
  Properties properties(element, builder.ids, builder.diagnostics);
  const ColorUse use = what == TextureUse::light    ? ColorUse::emission
                       : what == TextureUse::height ? ColorUse::height
                       : is_unbounded               ? ColorUse::value
                                                    : ColorUse::reflectance;
  Texture texture = reader(properties, builder, use);
  if (swaps_colours) {
    auto& board = std::get<Checkerboard>(texture.pattern);
    board.color0 = grey(mean_of(std::exchange(board.color1, grey(mean_of(board.color0)))));
  }
  auto* bitmap = std::get_if<Bitmap>(&texture.pattern);
  if (!is_unbounded && bitmap != nullptr) clamp_to_one(*bitmap, element.where, builder.diagnostics);
  texture.is_unbounded = is_unbounded;
  properties.report_unknown();
  texture.id = properties.id();
  texture.where = element.where;
  builder.scene.textures.push_back(std::move(texture));
  const int index = static_cast<int>(builder.scene.textures.size()) - 1;
  builder.texture_indices.emplace(std::pair(&element, what), index);
  return index;
}

/// The texture that a <spectrum type="d65"> stands around: as in Mitsuba's RGB variants, the spectrum is that texture.
/// Any other element is given back.
const XmlElement* without_d65(const XmlElement& element, SceneBuilder& builder) {
  if (element.text("type") != "d65") return &element;
  for (const XmlElement* child = element.first_child; child != nullptr; child = child->next_sibling) {
    Diagnostics told_by_its_reader(false);
    const XmlElement* meant = child->tag == "ref" ? builder.ids.resolve(*child, told_by_its_reader) : child;
    if (meant != nullptr && meant->tag == "texture" && !is_typed_spectrum(*meant)) return meant;
  }
  return &element;
}

/// Of a d65 around a texture: its scale is unknown there, as Mitsuba leaves it out.
void report_around(const XmlElement& element, SceneBuilder& builder) {
  Properties d65(element, builder.ids, builder.diagnostics);
  if (d65.objects("texture").size() > 1)
    builder.diagnostics.error(element.where, fmt::format("{} takes one <texture> inside", d65.title()));
  d65.report_unknown();
}

/// -1: no texture that strahl has.
int texture_of(Properties& properties, SceneBuilder& builder, const std::string& name,
               TextureUse use = TextureUse::colour) {
  const XmlElement* given = properties.peek(name);
  // <spectrum type="bitmap"> is another way to write it.
  if (given == nullptr || (given->tag != "texture" && given->tag != "spectrum")) return -1;
  const XmlElement* texture = without_d65(*given, builder);
  const TextureReader* reader = find_plugin(texture_readers(), texture->text("type"));
  if (reader == nullptr) return -1;
  if (texture != given) report_around(*given, builder);
  properties.accept({name.c_str()});
  return texture_index(*texture, *reader, builder, use);
}

}  // namespace

void clamp_to_one(Bitmap& bitmap, const SourceLocation& where, Diagnostics& diagnostics) {
  if (!bitmap.texels) return;
  Clamped clamped = clamped_to_one(*bitmap.texels);
  if (clamped.changed == 0) return;
  diagnostics.warning(
      where, fmt::format(
                 "{} of the {} texels of \"{}\" are brighter than 1, which is all that a surface can reflect; they are "
                 "taken for 1",
                 clamped.changed, clamped.texels.count(), clamped.texels.file));
  bitmap.texels = std::make_shared<const Texels>(std::move(clamped.texels));
  bitmap.mean = kinds::mean_of(*bitmap.texels, bitmap.curve);
}

std::array<double, 6> read_uv_map(Properties& properties) {
  if (const auto t = properties.transform("to_uv", TransformUse::uv))
    return {t->m[0][0], t->m[0][1], t->m[0][3], t->m[1][0], t->m[1][1], t->m[1][3]};
  const double scale = properties.number("uvscale").value_or(1);
  const double u = properties.number("uscale").value_or(scale), v = properties.number("vscale").value_or(scale);
  // As Mitsuba 3 upgrades them: moved, then scaled.
  const double u_offset = properties.number("uoffset").value_or(0), v_offset = properties.number("voffset").value_or(0);
  return {u, 0, u * u_offset, 0, v, v * v_offset};
}

Reflectance read_reflectance(Properties& properties, SceneBuilder& builder, const std::string& name,
                             const Rgb& absent) {
  if (const int texture = texture_of(properties, builder, name); texture >= 0) return {absent, texture};
  return {properties.color(name, ColorUse::reflectance, {0.5, 0.5, 0.5}).value_or(absent)};
}

Reflectance read_share(Properties& properties, SceneBuilder& builder, const std::string& name, double absent) {
  if (const int texture = texture_of(properties, builder, name, TextureUse::number); texture >= 0)
    return {grey(absent), texture};
  return {grey(mean_of(properties.color(name, ColorUse::reflectance, {0.5, 0.5, 0.5}).value_or(grey(absent))))};
}

Varying read_nested_texture(const XmlElement& element, SceneBuilder& builder, TextureUse use) {
  const std::string_view type = element.text("type");
  if (const TextureReader* reader = find_plugin(texture_readers(), type))
    return {{0.5, 0.5, 0.5}, texture_index(element, *reader, builder, use)};
  builder.diagnostics.unknown(element.where, not_available("texture", type, types_of(texture_readers())) +
                                                 "; the constant 0.5 takes its place");
  return {{0.5, 0.5, 0.5}};
}

Emission read_emission(Properties& properties, SceneBuilder& builder, const std::string& name) {
  const Rgb white{1, 1, 1};
  if (const int texture = texture_of(properties, builder, name, TextureUse::light); texture >= 0)
    return {white, texture};
  return {properties.color(name, ColorUse::emission, white).value_or(white)};
}

Varying read_varying(Properties& properties, SceneBuilder& builder, const std::string& name, const Rgb& absent) {
  if (const int texture = texture_of(properties, builder, name, TextureUse::value); texture >= 0)
    return {absent, texture};
  return {properties.color(name, ColorUse::value, absent).value_or(absent)};
}

Varying read_number(Properties& properties, SceneBuilder& builder, const std::string& name, const Rgb& absent,
                    TextureUse use) {
  if (const int texture = texture_of(properties, builder, name, use); texture >= 0) return {absent, texture};
  const Rgb given = properties.color(name, ColorUse::value, absent).value_or(absent);
  return {given == grey(given.r) ? given : grey(mean_of(given))};
}

}  // namespace strahl
