// SPDX-License-Identifier: MIT
// The image and volume files of a scene, each read once, or once for each use where that makes a difference.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "image/texels.h"
#include "scene/model/volume.h"
#include "scene/xml/diagnostics.h"

namespace strahl {

class ImageFiles {
 public:
  /// Null after an error; where: what is told with it.
  [[nodiscard]] std::shared_ptr<const Texels> read(const std::string& path, const SourceLocation& where,
                                                   Diagnostics& diagnostics, TexelUse use = TexelUse::light);
  [[nodiscard]] std::shared_ptr<const VolumeGrid> read_grid(const std::string& path, const SourceLocation& where,
                                                            Diagnostics& diagnostics);

 private:
  std::map<std::string, std::shared_ptr<const Texels>> files_, heights_;
  std::map<std::string, std::shared_ptr<const VolumeGrid>> grids_;
};

}  // namespace strahl
