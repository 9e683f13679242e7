// SPDX-License-Identifier: MIT
// An XML element with its place in the file. Everything after xml_file.cpp works on these and never sees pugixml.
//
// A scene may hold millions of them, so an element owns nothing: its children, its attributes and all texts lie in an
// XmlPool, which must outlive it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "errors.h"

namespace strahl {

/// A SourceLocation that shares the file's name with all others of that file.
struct XmlPlace {
  const std::string* file = nullptr;
  int line = 0;
  int column = 0;

  operator SourceLocation() const { return {*file, line, column}; }
};

/// Both end with a zero byte, as pugixml leaves them in the file's text.
struct XmlAttribute {
  const char* name;
  const char* value;
};

/// The tag of elements that no file has, as no name in XML begins with a digit: what xml_upgrade.h writes into an
/// element of Mitsuba 0.x to say which of its rules hold there. They have a name, and the value "true".
constexpr std::string_view old_rule_tag = "0.x";

struct XmlElement {
  std::string_view tag;
  std::span<XmlAttribute> attributes;
  XmlElement* first_child = nullptr;
  XmlElement* next_sibling = nullptr;
  XmlPlace where;  ///< Of the '<'.

  /// The attribute's text; none where it is absent.
  [[nodiscard]] std::optional<std::string_view> attribute(std::string_view name) const {
    for (const XmlAttribute& attribute : attributes)
      if (attribute.name == name) return attribute.value;
    return std::nullopt;
  }
  /// The attribute's text; empty where it is absent.
  [[nodiscard]] std::string_view text(std::string_view name) const { return attribute(name).value_or(""); }
};

}  // namespace strahl
