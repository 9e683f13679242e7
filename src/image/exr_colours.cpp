// SPDX-License-Identifier: MIT
#include "image/exr_colours.h"

#include <ImfChromaticities.h>
#include <ImfStandardAttributes.h>

#include <array>
#include <cmath>
#include <optional>

#include "image/named_colours.h"

namespace strahl {
namespace {

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
void convert(Image& image, const std::array<std::size_t, 3>& places, const Imath::M44f& matrix) {
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
  const std::optional<NamedColours> colours = named_colours(image.channels);
  if (!colours) return;
  const Imath::M44f from_xyz = Imf::XYZtoRGB(Imf::Chromaticities(), 1);
  if (colours->are_xyz) return convert(image, colours->places, from_xyz);
  if (!Imf::hasChromaticities(header) || are_rec_709(Imf::chromaticities(header))) return;
  convert(image, colours->places, Imf::RGBtoXYZ(Imf::chromaticities(header), 1) * from_xyz);
}

}  // namespace strahl
