// SPDX-License-Identifier: MIT
// The files of a rendered picture, and what is said about them.
#include "cli/picture_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "cli/console.h"
#include "cli/display.h"
#include "cli/output_file.h"

namespace strahl::cli {
namespace {

/// "out.depth.png" for "out.png".
std::string layer_path(const std::string& path, const std::string& layer_name) {
  std::filesystem::path beside(path);
  const std::string extension = beside.extension().string();
  beside.replace_extension(layer_name + extension);
  return beside.string();
}

float largest_finite(const Image& image) {
  float largest = 0;
  for (const float value : image.data)
    if (std::isfinite(value)) largest = std::max(largest, value);
  return largest;
}

void say_losses(const std::string& path, const Image& image, const WriteReport& report, double exposure) {
  if (report.invalid > 0)
    say(fmt::format("{}: {} of {} values are not finite", path, report.invalid, image.data.size()));
  if (report.clipped == 0) return;
  const double stops = std::floor(-std::log2(largest_finite(image)));
  const std::string remedy = stops < exposure ? fmt::format("; --exposure {:.0f} shows them", stops) : "";
  say(fmt::format("{}: {} of {} values clipped at 1{}", path, report.clipped, image.data.size(), remedy));
}

/// All channels of both in one image: what an EXR file holds.
Image merged(const Image& color, const Image& aov) {
  if (aov.channels.empty() || aov.data.empty()) return color;
  Image all = color;
  all.channels.insert(all.channels.end(), aov.channels.begin(), aov.channels.end());
  all.data.clear();
  all.data.reserve(color.data.size() + aov.data.size());
  const auto pixels = static_cast<std::size_t>(color.width) * static_cast<std::size_t>(color.height);
  const auto append = [&all](const Image& image, std::size_t pixel) {
    const auto first = image.data.begin() + static_cast<std::ptrdiff_t>(pixel * image.channels.size());
    all.data.insert(all.data.end(), first, first + static_cast<std::ptrdiff_t>(image.channels.size()));
  };
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    append(color, pixel);
    append(aov, pixel);
  }
  return all;
}

void write_color(const PictureFiles& files, Image color, bool is_png, bool quiet) {
  if (is_png && files.scale_color) {
    const double largest = scale_to_largest(color, "depth.white");
    if (!quiet && largest > 0)
      say(fmt::format("{}: values divided by the largest, {:.6g}; .exr and .pfm keep them", files.path, largest));
  }
  const WriteReport report = write_image(color, files.path, files.png);
  if (!quiet) say_losses(files.path, color, report, files.png.exposure);
}

}  // namespace

void require_writable(const PictureFiles& files) {
  static_cast<void>(image_format(files.path));
  require_writable(files.path);
}

void write(const PictureFiles& files, const RenderResult& result, const std::map<std::string, std::string>& metadata,
           bool quiet) {
  const ImageFormat format = image_format(files.path);
  Image color = result.color;
  color.metadata = metadata;
  if (format == ImageFormat::exr) return write_color(files, merged(color, result.aov), false, quiet);
  write_color(files, std::move(color), format == ImageFormat::png, quiet);
  if (result.aov.data.empty()) return;
  for (const std::string& name : layers(result.aov)) {
    Image values = layer(result.aov, name);
    values.metadata = metadata;
    PngOptions as_they_are = files.png;
    as_they_are.exposure = 0;  // These are no light.
    static_cast<void>(write_image(format == ImageFormat::png ? display(values, name) : plain(values),
                                  layer_path(files.path, name), as_they_are));
  }
}

}  // namespace strahl::cli
