// SPDX-License-Identifier: MIT
// OpenEXR's naming: "layer.channel"; the channels of the file itself have no layer.
#include "image/named_colours.h"

#include <unordered_map>

namespace strahl {
namespace {

struct Layer {
  std::array<std::optional<std::size_t>, 3> rgb, xyz;
};

std::optional<NamedColours> all_of(const std::array<std::optional<std::size_t>, 3>& found, bool are_xyz) {
  if (!found[0] || !found[1] || !found[2]) return std::nullopt;
  return NamedColours{{*found[0], *found[1], *found[2]}, are_xyz};
}

/// In the order of their first channels; that of the file itself is the first, whether it has any or not.
std::vector<Layer> layers_of(const std::vector<std::string>& channels) {
  std::vector<Layer> layers(1);
  std::unordered_map<std::string, std::size_t> known{{"", 0}};
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const std::size_t base = channels[c].rfind('.') + 1;  // 0 where there is no dot.
    const auto [entry, is_new] = known.try_emplace(channels[c].substr(0, base), layers.size());
    if (is_new) layers.emplace_back();
    Layer& layer = layers[entry->second];
    const std::string letter = channels[c].substr(base);
    for (std::size_t i = 0; i < 3; ++i) {
      if (letter == std::string(1, "RGB"[i])) layer.rgb.at(i) = c;
      if (letter == std::string(1, "XYZ"[i])) layer.xyz.at(i) = c;
    }
  }
  return layers;
}

}  // namespace

std::optional<NamedColours> named_colours(const std::vector<std::string>& channels) {
  const std::vector<Layer> layers = layers_of(channels);
  if (const auto rgb = all_of(layers[0].rgb, false)) return rgb;
  if (const auto xyz = all_of(layers[0].xyz, true)) return xyz;
  for (const Layer& layer : layers)
    if (const auto rgb = all_of(layer.rgb, false)) return rgb;
  if (layers[0].xyz[1]) return std::nullopt;  // Grey.
  for (const Layer& layer : layers)
    if (const auto xyz = all_of(layer.xyz, true)) return xyz;
  return std::nullopt;
}

}  // namespace strahl
