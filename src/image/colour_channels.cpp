// SPDX-License-Identifier: MIT
// OpenEXR's naming: "layer.channel", where the first layer may be without a name and alpha is "A".
#include "image/colour_channels.h"

namespace strahl {

std::vector<int> colour_channels(const Image& image) {
  std::vector<int> colours;
  std::string first_layer;
  for (std::size_t c = 0; c < image.channels.size() && colours.size() < 3; ++c) {
    const std::string& name = image.channels[c];
    const std::size_t base = name.rfind('.') + 1;  // 0 where there is no dot.
    const std::string layer = name.substr(0, base);
    if (c == 0) first_layer = layer;
    if (layer == first_layer && name.compare(base, std::string::npos, "A") != 0) colours.push_back(static_cast<int>(c));
  }
  return colours;
}

}  // namespace strahl
