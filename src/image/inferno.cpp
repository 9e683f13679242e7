// SPDX-License-Identifier: MIT
#include "image/inferno.h"

#include <algorithm>
#include <cmath>

#include "image/srgb.h"

namespace strahl {
namespace {

// inferno at 0, 1/9, ..., 1: 8-bit sRGB.
constexpr std::array<std::array<int, 3>, 10> entries{{{0x00, 0x00, 0x04},
                                                      {0x1b, 0x0c, 0x42},
                                                      {0x4b, 0x0c, 0x6b},
                                                      {0x78, 0x1c, 0x6d},
                                                      {0xa5, 0x2c, 0x60},
                                                      {0xcf, 0x44, 0x46},
                                                      {0xed, 0x69, 0x25},
                                                      {0xfb, 0x9a, 0x06},
                                                      {0xf7, 0xd0, 0x3c},
                                                      {0xfc, 0xff, 0xa4}}};

}  // namespace

std::array<float, 3> inferno(double t) {
  const double position = t * (entries.size() - 1);
  const std::size_t entry = std::min(static_cast<std::size_t>(position), entries.size() - 2);
  std::array<float, 3> colour{};  // Interpolated as encoded values, in which the map is even.
  for (std::size_t c = 0; c < 3; ++c) {
    const double code = std::lerp(entries[entry][c], entries[entry + 1][c], position - static_cast<double>(entry));
    colour[c] = static_cast<float>(linear_from_srgb(code / 255));
  }
  return colour;
}

}  // namespace strahl
