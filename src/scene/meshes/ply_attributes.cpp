// SPDX-License-Identifier: MIT
#include "scene/meshes/ply_attributes.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace strahl {
namespace {

/// One over the largest number of an integer type.
double share_of(PlyType type) {
  switch (type) {
    case PlyType::int8:
      return 1.0 / 127;
    case PlyType::uint8:
      return 1.0 / 255;
    case PlyType::int16:
      return 1.0 / 32767;
    case PlyType::uint16:
      return 1.0 / 65535;
    case PlyType::int32:
      return 1.0 / 2147483647;
    case PlyType::uint32:
      return 1.0 / 4294967295;
    default:
      return 1;
  }
}

}  // namespace

std::vector<PlyAttribute> attributes_of(const PlyElement& element, const std::string& prefix,
                                        const std::vector<bool>& is_taken) {
  std::vector<PlyAttribute> all;
  const auto free_property = [&](std::initializer_list<std::string_view> names) {
    const int i = element.find(names);
    return i >= 0 && !is_taken[static_cast<std::size_t>(i)] ? i : -1;
  };
  const std::array colour{free_property({"r", "red"}), free_property({"g", "green"}), free_property({"b", "blue"})};
  if (std::all_of(colour.begin(), colour.end(), [](int i) { return i >= 0; })) {
    PlyAttribute& attribute = all.emplace_back(PlyAttribute{prefix + "color", {}, 1});
    for (const int i : colour) attribute.properties.push_back(static_cast<std::size_t>(i));
  }
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    const std::string& name = element.properties[i].name;
    const std::size_t end = name.rfind('_');
    if (is_taken[i] || end == std::string::npos || end == 0 || end + 2 != name.size()) continue;
    const bool is_colour = name.ends_with("_r") || name.ends_with("_g") || name.ends_with("_b");
    const std::string attribute = prefix + name.substr(0, end) + (is_colour ? "_color" : "");
    const auto found = std::find_if(all.begin(), all.end(), [&](const PlyAttribute& a) { return a.name == attribute; });
    if (found == all.end())
      all.push_back({attribute, {i}, 1});
    else
      found->properties.push_back(i);
  }
  std::erase_if(all, [](const PlyAttribute& a) { return a.properties.size() != 1 && a.properties.size() != 3; });
  for (PlyAttribute& attribute : all)
    if (attribute.name.ends_with("color")) attribute.scale = share_of(element.properties[attribute.properties[0]].type);
  return all;
}

}  // namespace strahl
