// SPDX-License-Identifier: MIT
// A picture in memory: named float channels, interleaved, row 0 on top.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace strahl {

/// width x height x channels.size() floats, pixel-interleaved; linear light. Channel names as in OpenEXR: "R", "G",
/// "B", or with a layer, "normal.X". `metadata` goes into PNG text and EXR string attributes.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::string> channels{"R", "G", "B"};
  std::vector<float> data;
  std::map<std::string, std::string> metadata;

  [[nodiscard]] std::size_t index(int x, int y, int channel) const {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
               channels.size() +
           static_cast<std::size_t>(channel);
  }
  [[nodiscard]] float& at(int x, int y, int channel) { return data[index(x, y, channel)]; }
  [[nodiscard]] float at(int x, int y, int channel) const { return data[index(x, y, channel)]; }
};

}  // namespace strahl
