// SPDX-License-Identifier: MIT
// Values that are no light as pictures that can be looked at; docs/cli.md lists the mappings.
#include "cli/display.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "image/inferno.h"

namespace strahl::cli {
namespace {

std::size_t pixel_count(const Image& image) {
  return static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

Image rgb_like(const Image& image) {
  Image rgb;
  rgb.width = image.width;
  rgb.height = image.height;
  rgb.metadata = image.metadata;
  rgb.data.assign(pixel_count(image) * 3, 0.0F);
  return rgb;
}

/// Normals and positions of pixels where nothing was hit are zero; a hit at the very origin is taken for one.
bool is_zero(const float* v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; }

Image scaled_depth(const Image& layer, const std::string& name) {
  Image depth = layer;
  depth.channels = {"Y"};
  scale_to_largest(depth, name + ".white");
  return depth;
}

Image scaled_positions(const Image& layer, const std::string& name) {
  Image rgb = rgb_like(layer);
  for (std::size_t c = 0; c < 3; ++c) {
    float least = std::numeric_limits<float>::infinity();
    float largest = -least;
    for (std::size_t p = 0; p < pixel_count(layer); ++p) {
      const float value = layer.data[p * 3 + c];
      if (is_zero(&layer.data[p * 3]) || !std::isfinite(value)) continue;
      least = std::min(least, value);
      largest = std::max(largest, value);
    }
    if (least > largest) continue;
    rgb.metadata[fmt::format("{}.{}.range", name, "XYZ"[c])] = fmt::format("{} {}", least, largest);
    const float extent = largest > least ? largest - least : 1.0F;
    for (std::size_t p = 0; p < pixel_count(layer); ++p) {
      const float value = layer.data[p * 3 + c];
      if (!is_zero(&layer.data[p * 3]) && std::isfinite(value)) rgb.data[p * 3 + c] = (value - least) / extent;
    }
  }
  return rgb;
}

Image normals_as_colors(const Image& layer) {
  Image rgb = rgb_like(layer);
  for (std::size_t p = 0; p < pixel_count(layer); ++p) {
    const float* n = &layer.data[p * 3];
    for (std::size_t c = 0; c < 3 && !is_zero(n); ++c) rgb.data[p * 3 + c] = 0.5F + 0.5F * n[c];
  }
  return rgb;
}

/// Neighbouring ids get unlike colours: bytes of a mixed integer (the finaliser of Appleby's MurmurHash3, 2008).
Image ids_as_colors(const Image& layer) {
  Image rgb = rgb_like(layer);
  for (std::size_t p = 0; p < pixel_count(layer); ++p) {
    const float id = layer.data[p * layer.channels.size()];
    if (!(id >= 0)) continue;  // A miss.
    std::uint32_t h = static_cast<std::uint32_t>(id) + 1;
    h = (h ^ (h >> 16)) * 0x85ebca6bU;
    h = (h ^ (h >> 13)) * 0xc2b2ae35U;
    h ^= h >> 16;
    for (std::size_t c = 0; c < 3; ++c)
      rgb.data[p * 3 + c] = 0.05F + 0.95F * static_cast<float>((h >> (8 * c)) & 0xffU) / 255.0F;
  }
  return rgb;
}

/// Black: right to the last place; the map's end: nothing of 24 bits is right; cyan: hit for miss or miss for hit.
Image errors_as_colors(const Image& layer) {
  Image rgb = rgb_like(layer);
  for (std::size_t p = 0; p < pixel_count(layer); ++p) {
    const double ulps = static_cast<double>(layer.data[p]);
    const std::array<float, 3> color =
        std::isfinite(ulps) ? inferno(std::min(std::log2(1 + ulps) / 24, 1.0)) : std::array<float, 3>{0.0F, 1.0F, 1.0F};
    std::copy(color.begin(), color.end(), rgb.data.begin() + static_cast<std::ptrdiff_t>(p * 3));
  }
  return rgb;
}

}  // namespace

std::vector<std::string> layers(const Image& image) {
  std::vector<std::string> names;
  for (const std::string& channel : image.channels) {
    const std::string name = channel.substr(0, channel.find('.'));
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

Image layer(const Image& image, const std::string& name) {
  std::vector<std::size_t> sources;
  Image result;
  result.width = image.width;
  result.height = image.height;
  result.metadata = image.metadata;
  result.channels.clear();
  for (std::size_t c = 0; c < image.channels.size(); ++c) {
    if (image.channels[c].substr(0, image.channels[c].find('.')) != name) continue;
    sources.push_back(c);
    result.channels.push_back(image.channels[c]);
  }
  result.data.reserve(pixel_count(image) * sources.size());
  for (std::size_t p = 0; p < pixel_count(image); ++p)
    for (const std::size_t c : sources) result.data.push_back(image.data[p * image.channels.size() + c]);
  return result;
}

Image display(const Image& layer, const std::string& name) {
  if (name == "depth") return scaled_depth(layer, name);
  if (name == "position") return scaled_positions(layer, name);
  if (name == "normal" || name == "geo_normal") return normals_as_colors(layer);
  if (name == "shape_id" || name == "primitive_id") return ids_as_colors(layer);
  if (name == "numeric_error") return errors_as_colors(layer);
  return plain(layer);
}

Image plain(const Image& layer) {
  if (layer.channels.size() == 1) {
    Image grey = layer;
    grey.channels = {"Y"};
    return grey;
  }
  Image rgb = rgb_like(layer);
  const std::size_t stride = layer.channels.size();
  for (std::size_t p = 0; p < pixel_count(layer); ++p)
    for (std::size_t c = 0; c < std::min<std::size_t>(3, stride); ++c) rgb.data[p * 3 + c] = layer.data[p * stride + c];
  return rgb;
}

double scale_to_largest(Image& image, const std::string& key) {
  float largest = 0;
  for (const float value : image.data)
    if (std::isfinite(value)) largest = std::max(largest, value);
  for (float& value : image.data) {
    if (!std::isfinite(value))
      value = 0;
    else if (largest > 0)
      value /= largest;
  }
  if (largest > 0) image.metadata[key] = fmt::format("{}", largest);
  return largest;
}

}  // namespace strahl::cli
