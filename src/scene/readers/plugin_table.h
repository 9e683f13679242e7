// SPDX-License-Identifier: MIT
// From the type="..." of a plugin to its reader. The lists of entries (cl/*/*.def, kinds/shapes.def) are the only
// registration.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "did_you_mean.h"
#include "scene/readers/foreign_plugins.h"

namespace strahl {

template <class Reader>
using PluginTable = std::vector<std::pair<std::string, Reader>>;

template <class Reader>
[[nodiscard]] const Reader* find_plugin(const PluginTable<Reader>& table, std::string_view type) {
  for (const auto& [name, reader] : table)
    if (name == type) return &reader;
  return nullptr;
}

/// The types that a table has.
template <class Reader>
[[nodiscard]] std::vector<std::string> types_of(const PluginTable<Reader>& table) {
  std::vector<std::string> types;
  for (const auto& [name, reader] : table) types.push_back(name);
  return types;
}

template <class Reader>
[[nodiscard]] std::string did_you_mean_plugin(const PluginTable<Reader>& table, std::string_view type) {
  return did_you_mean(type, types_of(table));
}

}  // namespace strahl
