// SPDX-License-Identifier: MIT
// The files of a rendered picture, and what is said about them.
#include "cli/picture_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "cli/console.h"
#include "cli/display.h"
#include "cli/output_file.h"
#include "image/metrics.h"
#include "stopwatch.h"

namespace strahl::cli {
namespace {

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

Written write_color(const PictureFiles& files, Image color, bool is_png, bool quiet) {
  double white = 1;  // What the file's white stands for.
  PngOptions png = files.png;
  if (is_png && files.scale_color) {
    png.exposure = 0;  // Distances are no light.
    const double largest = scale_to_largest(color, "depth.white");
    if (largest > 0) white = largest;
    if (!quiet && largest > 0)
      say(fmt::format("{}: values divided by the largest, {:.6g}; .exr and .pfm keep them", files.path, largest));
  }
  WriteReport report = write_image(color, files.path, png);
  report.rounding_rmse *= white;
  report.clipping_rmse *= white;
  if (!quiet && report.invalid > 0)
    say(fmt::format("{}: {} of {} values are not finite", files.path, report.invalid, color.data.size()));
  if (!is_png || files.scale_color) return {report, std::nullopt};
  return {report, clipping_of(color, files.png.exposure, files.lamps)};
}

}  // namespace

std::string path_beside(const std::string& path, const std::string& name) {
  std::filesystem::path beside(path);
  const std::string extension = beside.extension().string();
  beside.replace_extension(name + extension);
  return beside.string();
}

void require_writable(const PictureFiles& files) {
  static_cast<void>(image_format(files.path));
  require_writable(files.path);
}

void require_writable_layers(const std::string& picture, const std::vector<std::string>& layers) {
  if (image_format(picture) == ImageFormat::exr) return;
  for (const std::string& name : layers) require_writable(path_beside(picture, name));
}

Written write(const PictureFiles& files, const RenderResult& result, const std::map<std::string, std::string>& metadata,
              bool quiet) {
  const ImageFormat format = image_format(files.path);
  Image color = result.color;
  color.metadata = metadata;
  if (format == ImageFormat::exr)
    return write_color(files, merged(merged(color, result.aov), result.named_aov), false, quiet);
  const Written written = write_color(files, std::move(color), format == ImageFormat::png, quiet);
  if (result.aov.data.empty()) return written;
  for (const std::string& name : layers(result.aov)) {
    Image values = layer(result.aov, name);
    values.metadata = metadata;
    PngOptions as_they_are = files.png;
    as_they_are.exposure = 0;  // These are no light.
    static_cast<void>(write_image(format == ImageFormat::png ? display(values, name) : plain(values),
                                  path_beside(files.path, name), as_they_are));
  }
  return written;
}

void write_error_map(const std::string& path, const Image& standard_error,
                     const std::map<std::string, std::string>& metadata) {
  Image map = standard_error;
  if (image_format(path) == ImageFormat::png) {
    Image none = standard_error;
    std::fill(none.data.begin(), none.data.end(), 0.0F);
    map = difference_heatmap(standard_error, none);
  }
  map.metadata.insert(metadata.begin(), metadata.end());
  static_cast<void>(write_image(map, path, PngOptions{}));
}

namespace {

/// The file is there only meanwhile.
double seconds_to_write(const Image& image, const std::filesystem::path& path, const PngOptions& png) {
  const Stopwatch start;
  static_cast<void>(write_image(image, path.string(), png));
  const double seconds = start.seconds();
  std::filesystem::remove(path);
  return seconds;
}

}  // namespace

WrittenFiles written_files(const std::string& path, const AovList& aovs) {
  // An EXR file holds every AOV; in other formats those of --aov have a file each, and a scene's own none.
  if (image_format(path) == ImageFormat::exr) return {1, 3 * (1 + aovs.size())};
  return {1 + aovs.plain().size(), 3};
}

double expected_write_seconds(const std::string& path, const PngOptions& png, double pixels, const AovList& aovs) {
  const auto [files, channels] = written_files(path, aovs);
  Image sample;
  sample.width = 256;
  sample.height = 32;
  sample.channels.resize(channels);
  for (std::size_t c = 3; c < channels; ++c) sample.channels[c] = "sample." + std::to_string(c);
  // Noise: what compresses worst.
  std::uint32_t bits = 1;
  for (std::size_t i = 0; i < sample.index(0, sample.height, 0); ++i) {
    bits = bits * 1664525U + 1013904223U;
    sample.data.push_back(static_cast<float>(bits >> 8) * 0x1p-24F);
  }
  const std::filesystem::path target(path);
  const std::string name = fmt::format("strahl-{}{}", std::chrono::steady_clock::now().time_since_epoch().count(),
                                       target.extension().string());
  std::error_code fault;
  const std::filesystem::path temporary = std::filesystem::temp_directory_path(fault);
  const double larger = static_cast<double>(files) * std::max(1.0, pixels / (sample.width * sample.height));
  try {
    if (!fault) return larger * seconds_to_write(sample, temporary / name, png);
  } catch (const Error&) {  // Full or read-only, which does not matter to the picture's own folder.
  }
  return larger * seconds_to_write(sample, target.parent_path() / name, png);
}

}  // namespace strahl::cli
