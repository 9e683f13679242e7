// SPDX-License-Identifier: MIT
// The rules of Mitsuba's own upgrade: parameter names become snake_case, names of <default> stay as they are since
// $name and -D refer to them.
#include "scene/xml/xml_upgrade.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>

namespace strahl {

namespace {

bool is_lower(char c) { return std::islower(static_cast<unsigned char>(c)) != 0; }
bool is_upper(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }

void rename(XmlElement& element, bool parameters, XmlPool& pool) {
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
    rename(*child, parameters, pool);
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
  rename(root, major < 2, pool);
}

}  // namespace strahl
