// SPDX-License-Identifier: MIT
// A scene may have a million elements, so texts without an f cost one look.
#include "scene/readers/number_suffixes.h"

#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>

#include "scene/xml/parse_value.h"

namespace strahl {

namespace {

/// Every word a number, of which some have an f behind them; else empty.
std::string without_suffixes(std::string_view text) {
  std::string plain;
  bool has_suffix = false;
  for (std::string_view word : split_list(text)) {
    if (word.size() > 1 && (word.back() == 'f' || word.back() == 'F')) {
      word.remove_suffix(1);
      has_suffix = true;
    }
    if (!parse_number(word)) return {};
    plain += word;
    plain += ' ';
  }
  return has_suffix ? plain : std::string();
}

/// Those that hold numbers, of whatever element.
bool may_be_numbers(const XmlElement& element, std::string_view attribute) {
  constexpr std::array names{"value", "x", "y", "z", "angle", "time", "origin", "target", "up"};
  for (const std::string_view name : names)
    if (attribute == name) return element.tag != "string";
  return false;
}

}  // namespace

void drop_number_suffixes(XmlElement& element, XmlPool& pool, Diagnostics& diagnostics) {
  for (XmlElement* child = element.first_child; child != nullptr; child = child->next_sibling)
    drop_number_suffixes(*child, pool, diagnostics);
  for (XmlAttribute& attribute : element.attributes) {
    const std::string_view text = attribute.value;
    if (text.find_first_of("fF") == std::string_view::npos || !may_be_numbers(element, attribute.name)) continue;
    std::string plain = without_suffixes(text);
    if (plain.empty()) continue;
    // Without quotes, so that many that differ in their digits alone are one note with a count.
    diagnostics.note(element.where,
                     fmt::format("{} in <{}> is read without its f, which Mitsuba 3.9 refuses", text, element.tag));
    attribute.value = pool.keep(std::move(plain)).c_str();
  }
}

}  // namespace strahl
