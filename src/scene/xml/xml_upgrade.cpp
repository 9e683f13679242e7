// SPDX-License-Identifier: MIT
// The rules of Mitsuba's own upgrade: parameter names become snake_case, names of <default> stay as they are since
// $name and -D refer to them.
#include "scene/xml/xml_upgrade.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>

#include "scene/xml/xml_vocabulary.h"

namespace strahl {

namespace {

/// Of a parameter that is given several times Mitsuba 0.x takes the last.
void drop_repeated(XmlElement& element, Diagnostics& diagnostics) {
  for (XmlElement** place = &element.first_child; XmlElement* child = *place;) {
    const std::string_view name = child->text("name");
    const XmlElement* later = child->next_sibling;
    const bool is_parameter = !name.empty() && child->tag != "default" && !is_object_tag(child->tag);
    while (is_parameter && later != nullptr && (later->text("name") != name || later->tag == "default"))
      later = later->next_sibling;
    if (is_parameter && later != nullptr) {
      diagnostics.warning(child->where, fmt::format("\"{}\" is given again at {}, which counts", name,
                                                    SourceLocation(later->where).text()));
      *place = child->next_sibling;
    } else {
      place = &child->next_sibling;
    }
  }
}

bool is_lower(char c) { return std::islower(static_cast<unsigned char>(c)) != 0; }
bool is_upper(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }

/// Before the others. tag, name and value outlive the document.
void add_parameter(XmlElement& element, XmlPool& pool, const char* tag, const char* name, const char* value) {
  XmlElement& parameter = pool.row<XmlElement>(1).front();
  parameter.tag = tag;
  parameter.attributes = pool.row<XmlAttribute>(2);
  parameter.attributes[0] = {"name", name};
  parameter.attributes[1] = {"value", value};
  parameter.where = element.where;
  parameter.next_sibling = element.first_child;
  element.first_child = &parameter;
}

/// In 0.x a metal without a name is copper, in Mitsuba 3 the ideal mirror.
void name_copper(XmlElement& element, XmlPool& pool) {
  const std::string_view type = element.text("type");
  if (element.tag != "bsdf" || (type != "conductor" && type != "roughconductor")) return;
  for (const XmlElement* child = element.first_child; child != nullptr; child = child->next_sibling)
    for (const char* given : {"material", "eta", "k"})
      if (child->text("name") == given) return;
  add_parameter(element, pool, "string", "material", "Cu");
}

/// In 0.x a sky's zenith is y, in Mitsuba 3 it is z.
void turn_sky(XmlElement& element, XmlPool& pool) {
  if (element.tag != "emitter" || element.text("type") != "sunsky") return;
  add_parameter(element, pool, "boolean", "is_y_up", "true");
}

/// In 0.x a grid lies in the box that its file states, in Mitsuba 3 in the unit cube.
void fill_box(XmlElement& element, XmlPool& pool) {
  if (element.tag != "volume" || element.text("type") != "gridvolume") return;
  add_parameter(element, pool, "boolean", "use_grid_bbox", "true");
}

/// In 0.x a boundary of media without a bsdf is a mere boundary, in Mitsuba 3 it is diffuse.
void open_boundary(XmlElement& element, XmlPool& pool) {
  if (element.tag != "shape") return;
  for (const XmlElement* child = element.first_child; child != nullptr; child = child->next_sibling)
    if (child->text("name") == "interior" || child->text("name") == "exterior")
      return add_parameter(element, pool, "boolean", "is_open_without_bsdf", "true");
}

/// 0.x takes diffuseReflectance, too, where there is no reflectance.
void call_reflectance(XmlElement& element) {
  const std::string_view type = element.text("type");
  if (element.tag != "bsdf" || (type != "diffuse" && type != "roughdiffuse")) return;
  for (const XmlElement* child = element.first_child; child != nullptr; child = child->next_sibling)
    if (child->text("name") == "reflectance") return;
  for (XmlElement* child = element.first_child; child != nullptr; child = child->next_sibling)
    for (XmlAttribute& attribute : child->attributes)
      if (attribute.name == std::string_view("name") && attribute.value == std::string_view("diffuse_reflectance"))
        attribute.value = "reflectance";
}

void rename(XmlElement& element, bool parameters, XmlPool& pool, Diagnostics& diagnostics) {
  if (element.tag == "lookAt") element.tag = "lookat";
  if (parameters && element.tag != "default") {
    for (XmlAttribute& attribute : element.attributes) {
      const std::string_view value = attribute.value;
      const bool is_camel_case = std::any_of(value.begin(), value.end(), is_upper);
      if (is_camel_case && attribute.name == std::string_view("name"))
        attribute.value = pool.keep(snake_case(value)).c_str();
    }
  }
  for (XmlElement* child = element.first_child; child != nullptr; child = child->next_sibling)
    rename(*child, parameters, pool, diagnostics);
  if (!parameters) return;
  drop_repeated(element, diagnostics);
  name_copper(element, pool);
  call_reflectance(element);
  open_boundary(element, pool);
  turn_sky(element, pool);
  fill_box(element, pool);
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

void upgrade_to_version_3(XmlElement& root, XmlPool& pool, Diagnostics& diagnostics) {
  int major = 3;
  if (const std::optional<std::string_view> version = root.attribute("version")) {
    const char* end = version->data() + version->size();
    const auto [rest, fault] = std::from_chars(version->data(), end, major);
    if (fault != std::errc{} || (rest != end && *rest != '.') || major < 0) {
      diagnostics.error(root.where, fmt::format("version \"{}\" is not a version such as \"3.0.0\"", *version));
      major = 3;
    } else if (major > 3) {
      diagnostics.unknown(root.where, fmt::format("version \"{}\" is newer than 3.x, as which it is read", *version));
    }
  } else if (root.tag == "scene") {
    diagnostics.warning(root.where, "<scene> has no version; it is read as version=\"3.0.0\"");
  }
  rename(root, major < 2, pool, diagnostics);
}

}  // namespace strahl
