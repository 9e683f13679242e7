// SPDX-License-Identifier: MIT
// Small pictures for the tests of the file formats.
#pragma once

#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "image/image.h"

namespace strahl::test {

inline const std::vector<std::string> rgb{"R", "G", "B"};

/// Values that a careless writer loses: zeros of both signs, denormals, extremes, infinities and a NaN.
inline std::vector<float> awkward_values() {
  using Limits = std::numeric_limits<float>;
  return {0.0F,
          -0.0F,
          1.0F,
          -2.5F,
          Limits::min(),
          Limits::denorm_min(),
          -1e-40F,
          Limits::max(),
          Limits::lowest(),
          Limits::infinity(),
          -Limits::infinity(),
          Limits::quiet_NaN(),
          0.1F,
          16777217.0F,
          1e-20F};
}

/// width x height x channels, filled with the values in turn.
inline Image picture(int width, int height, std::vector<std::string> channels, const std::vector<float>& values) {
  Image image;
  image.width = width;
  image.height = height;
  image.channels = std::move(channels);
  image.data.resize(image.index(0, height, 0));
  for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = values[i % values.size()];
  return image;
}

/// Bit patterns: NaN equals itself and the zeros differ.
inline std::vector<std::uint32_t> bits(const std::vector<float>& values) {
  std::vector<std::uint32_t> result(values.size());
  if (!values.empty()) std::memcpy(result.data(), values.data(), values.size() * sizeof(float));
  return result;
}

}  // namespace strahl::test
