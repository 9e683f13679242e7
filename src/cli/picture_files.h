// SPDX-License-Identifier: MIT
// The files of a rendered picture: one, or with AOVs in a PNG or PFM one a layer beside it.
#pragma once

#include <string>

#include "image/image_io.h"
#include "render/renderer.h"

namespace strahl::cli {

struct PictureFiles {
  std::string path;
  PngOptions png;
  bool scale_color = false;  ///< The picture's values are distances: a PNG shows them divided by the largest.
};

/// Throws UsageError (extension) or Error (folder) where the picture could not be written.
void require_writable(const PictureFiles& files);

/// Writes the picture and its AOVs with `metadata`, and says on standard error what was clipped or scaled unless quiet.
void write(const PictureFiles& files, const RenderResult& result, const std::map<std::string, std::string>& metadata,
           bool quiet);

}  // namespace strahl::cli
