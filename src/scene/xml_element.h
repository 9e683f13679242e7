// SPDX-License-Identifier: MIT
// An XML element with its place in the file. Everything after xml_file.cpp works on these and never sees pugixml.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "errors.h"

namespace strahl {

struct XmlElement {
  std::string tag;
  std::vector<std::pair<std::string, std::string>> attributes;
  std::vector<XmlElement> children;
  SourceLocation where;  ///< Of the '<'.

  /// The attribute's text; null where there is none.
  [[nodiscard]] const std::string* attribute(const std::string& name) const {
    for (const auto& [key, value] : attributes)
      if (key == name) return &value;
    return nullptr;
  }
  /// The attribute's text; empty where there is none.
  [[nodiscard]] std::string text(const std::string& name) const {
    const std::string* value = attribute(name);
    return value != nullptr ? *value : std::string{};
  }
};

}  // namespace strahl
