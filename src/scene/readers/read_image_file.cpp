// SPDX-License-Identifier: MIT
// The "filename" of textures, environments and volumes.
#include <fmt/format.h>

#include "image/file_bytes.h"
#include "scene/readers/read_texture.h"
#include "scene/xml/xml_expand.h"

namespace strahl {

std::optional<std::string> readable_path(Properties& properties, SceneBuilder& builder) {
  Diagnostics& diagnostics = builder.diagnostics;
  const std::optional<std::string> name = properties.string("filename");
  if (!name) {
    if (!properties.has("filename"))
      diagnostics.error(properties.where(), fmt::format("{} needs the string \"filename\"", properties.title()));
    return {};
  }
  const SourceLocation where = properties.where("filename");
  const std::string path = builder.search_path.find(*name, where.file);
  const std::string obstacle = unreadable_because(path);
  if (!obstacle.empty()) {
    diagnostics.unreadable(where, path, obstacle);
    return {};
  }
  return path;
}

std::shared_ptr<const Texels> read_image_file(Properties& properties, SceneBuilder& builder, TexelUse use) {
  const std::optional<std::string> path = readable_path(properties, builder);
  return path ? builder.images.read(*path, properties.where("filename"), builder.diagnostics, use) : nullptr;
}

}  // namespace strahl
