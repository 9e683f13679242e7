// SPDX-License-Identifier: MIT
// Ids are global and may be used before they are given, as in Mitsuba.
#include "scene/element_ids.h"

#include <fmt/format.h>

#include "scene/did_you_mean.h"

namespace strahl {

ElementIds::ElementIds(const XmlElement& root, Diagnostics& diagnostics) {
  collect(root, diagnostics);
  add_aliases(root, diagnostics);
}

void ElementIds::collect(const XmlElement& element, Diagnostics& diagnostics) {
  const std::string* id = element.tag == "ref" || element.tag == "alias" ? nullptr : element.attribute("id");
  if (id != nullptr) add(*id, element, element.where, diagnostics);
  for (const XmlElement& child : element.children) collect(child, diagnostics);
}

void ElementIds::add_aliases(const XmlElement& element, Diagnostics& diagnostics) {
  for (const XmlElement& child : element.children) {
    if (child.tag == "alias") {
      const XmlElement* named = resolve(child, diagnostics);
      if (named != nullptr) add(child.text("as"), *named, child.where, diagnostics);
    }
    add_aliases(child, diagnostics);
  }
}

void ElementIds::add(const std::string& id, const XmlElement& named, const SourceLocation& where,
                     Diagnostics& diagnostics) {
  const auto [entry, is_new] = elements_.emplace(id, &named);
  if (is_new) return;
  diagnostics.error(where,
                    fmt::format("duplicate id \"{}\"; it is already given at {}", id, entry->second->where.text()));
}

const XmlElement* ElementIds::resolve(const XmlElement& ref, Diagnostics& diagnostics) const {
  const std::string id = ref.text("id");
  const auto found = elements_.find(id);
  if (found != elements_.end()) return found->second;
  diagnostics.error(ref.where, fmt::format("nothing has the id \"{}\"{}", id, did_you_mean(id, names())));
  return nullptr;
}

std::vector<std::string> ElementIds::names() const {
  std::vector<std::string> all;
  for (const auto& [id, element] : elements_) all.push_back(id);
  return all;
}

}  // namespace strahl
