// SPDX-License-Identifier: MIT
// Which element an id names.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "scene/diagnostics.h"
#include "scene/xml_element.h"

namespace strahl {

class ElementIds {
 public:
  /// Collects id="..." and <alias> of the whole tree, which must outlive this; duplicates are errors.
  ElementIds(const XmlElement& root, Diagnostics& diagnostics);

  /// The element that a <ref> means. Null after an error: no such id.
  [[nodiscard]] const XmlElement* resolve(const XmlElement& ref, Diagnostics& diagnostics) const;

 private:
  void collect(const XmlElement& element, Diagnostics& diagnostics);
  void add_aliases(const XmlElement& element, Diagnostics& diagnostics);
  void add(const std::string& id, const XmlElement& named, const SourceLocation& where, Diagnostics& diagnostics);
  [[nodiscard]] std::vector<std::string> names() const;

  std::map<std::string, const XmlElement*> elements_;
};

}  // namespace strahl
