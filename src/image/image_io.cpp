// SPDX-License-Identifier: MIT
// Pictures by file extension, and the checks that all formats share.
#include "image/image_io.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <limits>
#include <set>

#include "errors.h"
#include "image/codecs.h"
#include "image/colour_channels.h"
#include "image/file_bytes.h"

namespace strahl {
namespace {

void check_image(const Image& image) {
  if (image.width < 1 || image.height < 1 || image.channels.empty()) {
    throw Error(fmt::format("a picture of {} x {} pixels with {} channels cannot be written", image.width, image.height,
                            image.channels.size()));
  }
  if (image.data.size() != image.index(0, image.height, 0)) {
    throw Error(fmt::format("a picture of {} x {} pixels with {} channels needs {} values and has {}", image.width,
                            image.height, image.channels.size(), image.index(0, image.height, 0), image.data.size()));
  }
  if (std::set(image.channels.begin(), image.channels.end()).size() != image.channels.size()) {
    throw Error(fmt::format("channel names must differ: {}", fmt::join(image.channels, ", ")));
  }
}

/// PNG and PFM hold a colour and nothing else.
void check_colour(const Image& image, const std::string& path) {
  if (colour_channels(image).empty())
    throw Error(
        fmt::format("\"{}\" would be empty: its format holds a colour, and the picture's channels, {}, have none", path,
                    fmt::join(image.channels, ", ")));
}

}  // namespace

ImageFormat image_format(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".png") return ImageFormat::png;
  if (extension == ".exr") return ImageFormat::exr;
  if (extension == ".pfm") return ImageFormat::pfm;
  throw UsageError(fmt::format("\"{}\": {}; known are .png, .exr and .pfm", path,
                               extension.empty() ? "a picture's name needs an extension"
                                                 : fmt::format("unknown picture format \"{}\"", extension)));
}

WriteReport write_image(const Image& image, const std::string& path, const PngOptions& png) {
  const ImageFormat format = image_format(path);
  check_image(image);
  if (format != ImageFormat::exr) check_colour(image, path);
  switch (format) {
    case ImageFormat::png:
      return write_png(image, path, png);
    case ImageFormat::exr:
      return write_exr(image, path);
    case ImageFormat::pfm:
      break;
  }
  return write_pfm(image, path);
}

Image read_image(const std::string& path) {
  const ImageFormat format = image_format(path);
  const std::string bytes = read_file(path);
  switch (format) {
    case ImageFormat::png:
      return read_png(path, bytes);
    case ImageFormat::exr:
      return read_exr(path, bytes);
    case ImageFormat::pfm:
      break;
  }
  return read_pfm(path, bytes);
}

void check_picture_size(const std::string& path, std::int64_t width, std::int64_t height, std::size_t channels,
                        std::size_t file_bytes, const ClaimLimit& claim) {
  constexpr std::size_t limit = std::size_t{1} << 30;  // Values: 4 GiB.
  constexpr std::int64_t longest = std::numeric_limits<int>::max();
  const double values = static_cast<double>(width) * static_cast<double>(height) * static_cast<double>(channels);
  if (width < 1 || height < 1 || width > longest || height > longest || channels < 1 ||
      values > static_cast<double>(std::min(limit, std::max(claim.always, file_bytes * claim.per_byte)))) {
    throw InputError(fmt::format("\"{}\": {} x {} pixels with {} channels in {} bytes: damaged, or too large", path,
                                 width, height, channels, file_bytes));
  }
}

}  // namespace strahl
