// SPDX-License-Identifier: MIT
// Capitals: Mitsuba loads a plugin by the name of its file, and some file systems ignore case there, so that scenes
// with such names were rendered by it. Mirror and glass: the names that other renderers' formats use for them.
#include "scene/readers/other_names.h"

#include <algorithm>
#include <cctype>

#include "scene/readers/foreign_plugins.h"
#include "scene/xml/parse_value.h"

namespace strahl {

namespace {

bool is_type_of_mitsuba(std::string_view tag, std::string_view type) {
  const std::vector<std::string>& types = mitsuba_types(tag);
  return std::find(types.begin(), types.end(), type) != types.end();
}

bool has_capitals(std::string_view text) {
  return std::any_of(text.begin(), text.end(), [](unsigned char c) { return std::isupper(c) != 0; });
}

XmlElement* parameter(XmlElement& element, std::string_view name) {
  for (XmlElement* child = element.first_child; child != nullptr; child = child->next_sibling)
    if (child->text("name") == name) return child;
  return nullptr;
}

XmlAttribute* attribute(XmlElement& element, std::string_view name) {
  const auto found = std::find_if(element.attributes.begin(), element.attributes.end(),
                                  [&](const XmlAttribute& candidate) { return candidate.name == name; });
  return found == element.attributes.end() ? nullptr : &*found;
}

}  // namespace

void use_mitsuba_names(XmlElement& element, XmlPool& pool) {
  for (XmlElement* child = element.first_child; child != nullptr; child = child->next_sibling)
    use_mitsuba_names(*child, pool);
  XmlAttribute* type = attribute(element, "type");
  if (type == nullptr) return;
  // No plugin of Mitsuba has any, and a scene may have a million elements.
  std::string lower;
  if (has_capitals(type->value)) lower = lower_case(type->value);
  if (!lower.empty() && is_type_of_mitsuba(element.tag, lower)) type->value = pool.keep(lower).c_str();
  if (element.tag != "bsdf") return;
  const std::string_view name = lower.empty() ? std::string_view(type->value) : lower;
  if (name == "mirror") {
    type->value = "conductor";
    if (XmlElement* reflectance = parameter(element, "reflectance"))
      attribute(*reflectance, "name")->value = "specular_reflectance";
  }
  if (name == "glass") type->value = parameter(element, "alpha") != nullptr ? "roughdielectric" : "dielectric";
}

}  // namespace strahl
