// SPDX-License-Identifier: MIT
#include "image/exr_colours.h"

#include <ImfChromaticities.h>
#include <ImfStandardAttributes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace strahl {
namespace {

using Places = std::array<std::size_t, 3>;

/// Where three channels stand.
std::optional<Places> places_of(const Image& image, const std::array<const char*, 3>& names) {
  Places places{};
  for (std::size_t c = 0; c < 3; ++c) {
    const auto found = std::find(image.channels.begin(), image.channels.end(), names.at(c));
    if (found == image.channels.end()) return std::nullopt;
    places.at(c) = static_cast<std::size_t>(found - image.channels.begin());
  }
  return places;
}

bool are_rec_709(const Imf::Chromaticities& given) {
  constexpr float far = 1e-4F;  // More than files round.
  const Imf::Chromaticities own;
  const auto is_close = [](const Imath::V2f& a, const Imath::V2f& b) {
    return std::fabs(a.x - b.x) <= far && std::fabs(a.y - b.y) <= far;
  };
  return is_close(given.red, own.red) && is_close(given.green, own.green) && is_close(given.blue, own.blue) &&
         is_close(given.white, own.white);
}

/// The library's matrices take rows from the left.
void convert(Image& image, const Places& places, const Imath::M44f& matrix) {
  for (std::size_t first = 0; first < image.data.size(); first += image.channels.size()) {
    float* pixel = &image.data[first];
    const Imath::V3f from(pixel[places[0]], pixel[places[1]], pixel[places[2]]);
    for (std::size_t c = 0; c < 3; ++c) {
      const int column = static_cast<int>(c);
      pixel[places.at(c)] = from.x * matrix[0][column] + from.y * matrix[1][column] + from.z * matrix[2][column];
    }
  }
}

}  // namespace

void convert_to_rec_709(Image& image, const Imf::Header& header) {
  const Imath::M44f from_xyz = Imf::XYZtoRGB(Imf::Chromaticities(), 1);
  if (const auto rgb = places_of(image, {"R", "G", "B"})) {
    if (!Imf::hasChromaticities(header) || are_rec_709(Imf::chromaticities(header))) return;
    convert(image, *rgb, Imf::RGBtoXYZ(Imf::chromaticities(header), 1) * from_xyz);
  } else if (const auto xyz = places_of(image, {"X", "Y", "Z"})) {
    convert(image, *xyz, from_xyz);
    constexpr std::array<const char*, 3> names = {"R", "G", "B"};
    for (std::size_t c = 0; c < 3; ++c) image.channels[xyz->at(c)] = names.at(c);
  }
}

}  // namespace strahl
