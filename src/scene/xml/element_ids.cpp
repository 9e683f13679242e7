// SPDX-License-Identifier: MIT
// Ids are global and may be used before they are given, as in Mitsuba.
#include "scene/xml/element_ids.h"

#include <fmt/format.h>

namespace strahl {

ElementIds::ElementIds(const XmlElement& root, Diagnostics& diagnostics) {
  std::vector<const XmlElement*> aliases;
  collect(root, aliases, diagnostics);
  for (const XmlElement* alias : aliases) {
    const XmlElement* named = resolve(*alias, diagnostics);
    if (named != nullptr) add(alias->text("as"), *named, alias->where, diagnostics);
  }
}

void ElementIds::collect(const XmlElement& element, std::vector<const XmlElement*>& aliases, Diagnostics& diagnostics) {
  if (element.tag == "alias") {
    aliases.push_back(&element);
  } else if (element.tag != "ref") {
    if (const auto id = element.attribute("id")) add(*id, element, element.where, diagnostics);
  }
  for (const XmlElement* child = element.first_child; child != nullptr; child = child->next_sibling)
    collect(*child, aliases, diagnostics);
}

void ElementIds::add(std::string_view id, const XmlElement& named, const XmlPlace& where, Diagnostics& diagnostics) {
  const auto [entry, is_new] = elements_.emplace(id, &named);
  if (is_new) return;
  diagnostics.error(where, fmt::format("duplicate id \"{}\"; it is already given at {}", id,
                                       SourceLocation(entry->second->where).text()));
}

const XmlElement* ElementIds::find(std::string_view id) const {
  const auto found = elements_.find(id);
  return found == elements_.end() ? nullptr : found->second;
}

const XmlElement* ElementIds::resolve(const XmlElement& ref, Diagnostics& diagnostics) const {
  const std::string_view id = ref.text("id");
  if (const XmlElement* found = find(id)) return found;
  diagnostics.error(ref.where, fmt::format("nothing has the id \"{}\"{}", id,
                                           suggestions_(id, elements_.size(), [this] { return names(); })));
  return nullptr;
}

std::vector<std::string> ElementIds::names() const {
  std::vector<std::string> all;
  for (const auto& [id, element] : elements_) all.emplace_back(id);
  return all;
}

}  // namespace strahl
