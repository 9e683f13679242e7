// SPDX-License-Identifier: MIT
// Which element an id names.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "did_you_mean.h"
#include "scene/xml/diagnostics.h"
#include "scene/xml/xml_element.h"

namespace strahl {

class ElementIds {
 public:
  /// Collects id="..." and <alias> of the whole tree, which must outlive this; duplicates are errors.
  ElementIds(const XmlElement& root, Diagnostics& diagnostics);

  /// The element that a <ref> means. Null after an error: no such id.
  [[nodiscard]] const XmlElement* resolve(const XmlElement& ref, Diagnostics& diagnostics) const;
  /// What has that id; null where nothing has.
  [[nodiscard]] const XmlElement* find(std::string_view id) const;

 private:
  void collect(const XmlElement& element, std::vector<const XmlElement*>& aliases, Diagnostics& diagnostics);
  void add(std::string_view id, const XmlElement& named, const XmlPlace& where, Diagnostics& diagnostics);
  [[nodiscard]] std::vector<std::string> names() const;

  std::map<std::string_view, const XmlElement*> elements_;
  mutable Suggestions suggestions_;  ///< For ids that nothing has.
};

}  // namespace strahl
