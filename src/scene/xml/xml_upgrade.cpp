// SPDX-License-Identifier: MIT
// The rules of Mitsuba's own upgrade: parameter names become snake_case, names of <default> stay as they are since
// $name and -D refer to them.
#include "scene/xml/xml_upgrade.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "scene/xml/parse_value.h"
#include "scene/xml/xml_vocabulary.h"

namespace strahl {

namespace {

/// In whatever case: types in capitals are Mitsuba's (scene/readers/other_names.h).
bool is_a(const XmlElement& element, std::string_view tag, std::string_view type) {
  const std::string_view given = element.text("type");
  return element.tag == tag &&
         std::ranges::equal(given, type, [](unsigned char a, unsigned char b) { return std::tolower(a) == b; });
}

bool is_object(const XmlElement& element) { return element.tag == "ref" || is_object_tag(element.tag); }

/// Whether the objects inside it are a list: all of a scene's, parts of a material or of a phase function, shapes of a
/// group.
bool has_parts(const XmlElement& element) {
  return element.tag == "scene" || element.tag == "bsdf" || element.tag == "phase" ||
         is_a(element, "shape", "shapegroup");
}

/// Of a parameter that is given several times Mitsuba 0.x takes the last. Objects, to which others may refer, stay, and
/// so do references where the parent has several objects: of those with one name the last keeps it, the others have
/// none.
void drop_repeated(XmlElement& element, Diagnostics& diagnostics) {
  std::vector<XmlElement*> children;
  for (XmlElement* child = element.first_child; child != nullptr; child = child->next_sibling)
    if (!child->text("name").empty()) children.push_back(child);
  std::unordered_map<std::string_view, const XmlElement*> later;
  std::unordered_set<const XmlElement*> dropped;
  for (std::size_t i = children.size(); i-- > 0;) {
    XmlElement& child = *children[i];
    const auto [next, is_last] = later.try_emplace(child.text("name"), &child);
    if (is_last) continue;
    const XmlElement& last = *next->second;
    if (is_object(child) && (child.tag != "ref" || (is_object(last) && (has_parts(element) || last.tag != "ref")))) {
      for (XmlAttribute& attribute : child.attributes)
        if (attribute.name == std::string_view("name")) attribute.value = "";
      continue;
    }
    diagnostics.warning(child.where, fmt::format("\"{}\" is given again at {}, which counts", child.text("name"),
                                                 SourceLocation(last.where).text()));
    dropped.insert(&child);
    next->second = &child;
  }
  if (dropped.empty()) return;
  for (XmlElement** place = &element.first_child; XmlElement* child = *place;) {
    if (dropped.contains(child))
      *place = child->next_sibling;
    else
      place = &child->next_sibling;
  }
}

bool is_lower(char c) { return std::islower(static_cast<unsigned char>(c)) != 0; }
bool is_upper(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }

bool has_child(const XmlElement& element, std::string_view name) {
  for (const XmlElement* child = element.first_child; child != nullptr; child = child->next_sibling)
    if (child->text("name") == name) return true;
  return false;
}

/// Before the others. tag, name and value outlive the document.
void add_parameter(XmlElement& element, XmlPool& pool, std::string_view tag, const char* name, const char* value) {
  XmlElement& parameter = pool.row<XmlElement>(1).front();
  parameter.tag = tag;
  parameter.attributes = pool.row<XmlAttribute>(2);
  parameter.attributes[0] = {"name", name};
  parameter.attributes[1] = {"value", value};
  parameter.where = element.where;
  parameter.next_sibling = element.first_child;
  element.first_child = &parameter;
}

/// Properties::has_old_rule() finds it.
void add_rule(XmlElement& element, XmlPool& pool, const char* name) {
  add_parameter(element, pool, old_rule_tag, name, "true");
}

/// In 0.x a metal without a name is copper, and eta and k replace its own, each by itself. In Mitsuba 3 it is the ideal
/// mirror, and a name excludes eta and k.
void name_copper(XmlElement& element, XmlPool& pool) {
  if (!is_a(element, "bsdf", "conductor") && !is_a(element, "bsdf", "roughconductor")) return;
  if (!has_child(element, "material")) add_parameter(element, pool, "string", "material", "Cu");
  add_rule(element, pool, "eta_and_k_replace_named");
}

/// In 0.x the last bsdf of a shape counts, in Mitsuba 3 more than one is an error. Which <ref>s are bsdfs shows later.
void take_last_bsdf(XmlElement& element, XmlPool& pool) {
  if (element.tag != "shape" || has_parts(element) || is_a(element, "shape", "instance")) return;
  int count = 0;
  for (const XmlElement* child = element.first_child; child != nullptr; child = child->next_sibling)
    if (child->tag == "bsdf" || child->tag == "ref") ++count;
  if (count > 1) add_rule(element, pool, "takes_last_bsdf");
}

/// In 0.x a sky's zenith is y, in Mitsuba 3 it is z.
void turn_sky(XmlElement& element, XmlPool& pool) {
  if (!is_a(element, "emitter", "sunsky")) return;
  add_rule(element, pool, "is_y_up");
}

/// In 0.x a grid lies in the box that its file states, in Mitsuba 3 in the unit cube.
void fill_box(XmlElement& element, XmlPool& pool) {
  if (!is_a(element, "volume", "gridvolume")) return;
  add_parameter(element, pool, "boolean", "use_grid_bbox", "true");
}

/// In 0.x a boundary of media without a bsdf is a mere boundary, in Mitsuba 3 it is diffuse.
void open_boundary(XmlElement& element, XmlPool& pool) {
  if (element.tag != "shape") return;
  if (has_child(element, "interior") || has_child(element, "exterior")) add_rule(element, pool, "is_open_without_bsdf");
}

/// 0.x takes diffuseReflectance, too, where there is no reflectance.
void call_reflectance(XmlElement& element) {
  if (!is_a(element, "bsdf", "diffuse") && !is_a(element, "bsdf", "roughdiffuse")) return;
  if (has_child(element, "reflectance")) return;
  for (XmlElement* child = element.first_child; child != nullptr; child = child->next_sibling)
    for (XmlAttribute& attribute : child->attributes)
      if (attribute.name == std::string_view("name") && attribute.value == std::string_view("diffuse_reflectance"))
        attribute.value = "reflectance";
}

/// In 0.x a normal map is the texture inside, whatever its name.
void take_normals(XmlElement& element, XmlPool& pool) {
  if (is_a(element, "bsdf", "normalmap") && !has_child(element, "normalmap"))
    add_rule(element, pool, "takes_any_texture");
}

/// 0.x shades a serialized mesh flat where its file says so, which Mitsuba 3 ignores.
void obey_serialized_file(XmlElement& element, XmlPool& pool) {
  if (is_a(element, "shape", "serialized")) add_rule(element, pool, "obeys_file_on_face_normals");
}

/// 0.x has a default of its own for how far ambient occlusion looks.
void limit_occlusion(XmlElement& element, XmlPool& pool) {
  if (is_a(element, "integrator", "ao") && !has_child(element, "max_distance"))
    add_rule(element, pool, "looks_as_far_as_0x");
}

void name_materials(XmlElement& element, XmlPool& pool) {
  for (const XmlElement* child = element.first_child; child != nullptr; child = child->next_sibling)
    if (has_own_name(*child, &element) && !child->text("name").empty())
      return add_rule(element, pool, "has_named_bsdfs");
}

/// In 0.x the hexadecimal digits of an <rgb> are linear, those of an <srgb> alone are encoded.
void write_out_hex(XmlElement& element, XmlPool& pool) {
  if (element.tag != "rgb") return;
  for (XmlAttribute& attribute : element.attributes)
    if (const auto hex = parse_hex(attribute.value); hex && attribute.name == std::string_view("value"))
      attribute.value =
          pool.keep(fmt::format("{}, {}, {}", (*hex)[0] / 255.0, (*hex)[1] / 255.0, (*hex)[2] / 255.0)).c_str();
}

void rename_parameter(XmlElement& element, const XmlElement* parent, XmlPool& pool) {
  if (has_own_name(element, parent)) return;
  for (XmlAttribute& attribute : element.attributes) {
    const std::string_view value = attribute.value;
    const bool is_camel_case = std::any_of(value.begin(), value.end(), is_upper);
    if (is_camel_case && attribute.name == std::string_view("name"))
      attribute.value = pool.keep(snake_case(value)).c_str();
  }
}

/// parent: what it is within; null of the main file's root.
void upgrade(XmlElement& element, const XmlElement* parent, bool is_old, XmlPool& pool, Diagnostics& diagnostics) {
  if (element.tag == "lookAt") element.tag = "lookat";
  if (is_old) rename_parameter(element, parent, pool);
  // An included <scene> goes: what it holds takes the place of the <include>.
  const XmlElement& around = element.tag == "scene" && parent != nullptr ? *parent : element;
  for (XmlElement* child = element.first_child; child != nullptr; child = child->next_sibling)
    if (child->where.file == element.where.file) upgrade(*child, &around, is_old, pool, diagnostics);
  if (!is_old) return;
  drop_repeated(element, diagnostics);
  write_out_hex(element, pool);
  take_last_bsdf(element, pool);
  name_copper(element, pool);
  call_reflectance(element);
  open_boundary(element, pool);
  turn_sky(element, pool);
  fill_box(element, pool);
  take_normals(element, pool);
  obey_serialized_file(element, pool);
  limit_occlusion(element, pool);
  name_materials(element, pool);
}

}  // namespace

std::string snake_case(std::string_view name) {
  std::string snake;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool hump = i > 0 && is_upper(name[i]) && is_lower(name[i - 1]);
    if (hump) snake += '_';
    const bool inside = i > 0 && is_upper(name[i]);
    snake += inside ? static_cast<char>(std::tolower(static_cast<unsigned char>(name[i]))) : name[i];
  }
  return snake;
}

bool has_own_name(const XmlElement& element, const XmlElement* parent) {
  return parent != nullptr && is_a(*parent, "shape", "obj") && (element.tag == "bsdf" || element.tag == "ref");
}

int major_version(const XmlElement& root, int inherited, Diagnostics& diagnostics) {
  const std::optional<std::string_view> version = root.attribute("version");
  if (!version && root.tag != "scene") return inherited;
  if (!version) {
    diagnostics.warning(root.where, "<scene> has no version; it is read as version=\"3.0.0\"");
    return 3;
  }
  int major = 3;
  const char* end = version->data() + version->size();
  const auto [rest, fault] = std::from_chars(version->data(), end, major);
  if (fault != std::errc{} || (rest != end && *rest != '.') || major < 0) {
    diagnostics.error(root.where, fmt::format("version \"{}\" is not a version such as \"3.0.0\"", *version));
    return 3;
  }
  if (major > 3)
    diagnostics.unknown(root.where, fmt::format("version \"{}\" is newer than 3.x, as which it is read", *version));
  return major;
}

void upgrade_to_version_3(XmlElement& root, const XmlElement* parent, int major, XmlPool& pool,
                          Diagnostics& diagnostics) {
  upgrade(root, parent, is_of_0x(major), pool, diagnostics);
}

}  // namespace strahl
