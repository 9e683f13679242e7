// SPDX-License-Identifier: MIT
// The files of a rendered picture: one, or with AOVs in a PNG or PFM one a layer beside it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/clipping.h"
#include "image/image_io.h"
#include "render/renderer.h"

namespace strahl::cli {

struct PictureFiles {
  std::string path;
  PngOptions png;
  bool scale_color = false;  ///< The picture's values are distances: a PNG shows them divided by the largest.
  std::vector<Rgb> lamps{};  ///< lamps_of the scene, where it is said which exposure would do.
};

/// What the picture has lost.
struct Written {
  WriteReport report;
  std::optional<Clipping> clipping;  ///< None where the file has no white.
};

/// "out.depth.png" for "out.png" and "depth".
[[nodiscard]] std::string path_beside(const std::string& path, const std::string& name);

/// Throws UsageError (extension) or Error (folder) where the picture could not be written.
void require_writable(const PictureFiles& files);
/// The same for the files of layers.
void require_writable_layers(const std::string& picture, const std::vector<std::string>& layers);

/// Writes the picture and its AOVs with `metadata`, and says on standard error what was scaled or is no number, unless
/// quiet.
Written write(const PictureFiles& files, const RenderResult& result, const std::map<std::string, std::string>& metadata,
              bool quiet);

/// --error-map: the standard error itself (.exr, .pfm), or in false colours (.png).
void write_error_map(const std::string& path, const Image& standard_error,
                     const std::map<std::string, std::string>& metadata);

/// What write() writes for a picture and its AOVs.
struct WrittenFiles {
  std::size_t files = 1;
  std::size_t channels = 3;  ///< Of each.
};
[[nodiscard]] WrittenFiles written_files(const std::string& path, const AovList& aovs);

/// Seconds that write() may take for a picture and its AOVs, told from a small file in the same format.
[[nodiscard]] double expected_write_seconds(const std::string& path, const PngOptions& png, double pixels,
                                            const AovList& aovs = {});

}  // namespace strahl::cli
