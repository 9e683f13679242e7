// SPDX-License-Identifier: MIT
#include "scene/meshes/ply_attributes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
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

/// The place among its attribute's components that the last letter of a property's name says: r, g, b; else 0, 1, 2 or
/// x, y, z or whatever letters there are, in the alphabet's order.
std::size_t place_of(const std::string& property) {
  constexpr std::string_view colours = "rgb";
  const std::size_t colour = colours.find(property.back());
  return colour != std::string_view::npos
             ? colour
             : colours.size() + static_cast<std::size_t>(static_cast<unsigned char>(property.back()));
}

}  // namespace

std::vector<PlyAttribute> attributes_of(const PlyElement& element, const std::string& prefix,
                                        const std::vector<bool>& is_taken, MeshSource& source) {
  std::vector<PlyAttribute> all;
  const auto free_property = [&](std::initializer_list<std::string_view> names) {
    const int i = element.find(names);
    return i >= 0 && !is_taken[static_cast<std::size_t>(i)] ? i : -1;
  };
  const std::array colour{free_property({"r", "red"}), free_property({"g", "green"}), free_property({"b", "blue"})};
  const bool has_colour = std::all_of(colour.begin(), colour.end(), [](int i) { return i >= 0; });
  if (has_colour) {
    PlyAttribute& attribute = all.emplace_back(PlyAttribute{prefix + "color", {}, 1});
    for (const int i : colour) attribute.properties.push_back(static_cast<std::size_t>(i));
  }
  std::map<std::string, std::size_t> numbers;  // In `all`, of the attributes that are named by an underscore.
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    const std::string& name = element.properties[i].name;
    const std::size_t end = name.rfind('_');
    if (is_taken[i] || end == std::string::npos || end == 0 || end + 2 != name.size()) continue;
    const bool is_colour = name.ends_with("_r") || name.ends_with("_g") || name.ends_with("_b");
    const std::string attribute = prefix + name.substr(0, end) + (is_colour ? "_color" : "");
    if (has_colour && attribute == all.front().name) {
      source.warn(element.at, fmt::format("the property {} is left out: r, g and b (or red, green and blue) are \"{}\" "
                                          "already; give one of the two another name",
                                          name, attribute));
      continue;
    }
    const auto [number, is_new] = numbers.try_emplace(attribute, all.size());
    if (is_new) all.push_back({attribute, {}, 1});
    all[number->second].properties.push_back(i);
  }
  std::erase_if(all, [](const PlyAttribute& a) { return a.properties.size() != 1 && a.properties.size() != 3; });
  const auto is_before = [&](std::size_t a, std::size_t b) {
    return place_of(element.properties[a].name) < place_of(element.properties[b].name);
  };
  for (std::size_t n = has_colour ? 1 : 0; n < all.size(); ++n)
    std::stable_sort(all[n].properties.begin(), all[n].properties.end(), is_before);
  for (PlyAttribute& attribute : all)
    if (attribute.name.ends_with("color")) attribute.scale = share_of(element.properties[attribute.properties[0]].type);
  return all;
}

}  // namespace strahl
