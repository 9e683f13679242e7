// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "image/file_bytes.h"
#include "scene/readers/mesh_import.h"
#include "scene/readers/shape_reader.h"

namespace strahl {

std::optional<std::string> data_path(ShapeInput& input, std::string_view extension) {
  Properties& properties = input.properties;
  Diagnostics& diagnostics = input.builder.diagnostics;
  const std::optional<std::string> name = properties.string("filename");
  if (!name) {
    if (!properties.has("filename"))
      diagnostics.error(properties.where(), fmt::format("{} needs the string \"filename\"", properties.title()));
    return std::nullopt;
  }
  const SourceLocation where = properties.where("filename");
  const std::string path = input.builder.search_path.find(*name, where.file);
  const std::string obstacle = unreadable_because(path);
  if (!obstacle.empty()) {
    diagnostics.unreadable(where, path, obstacle);
    return std::nullopt;
  }
  if (lower_case_extension(path) != fmt::format(".{}", extension)) {
    diagnostics.error(where,
                      fmt::format("\"{}\" does not end in .{}, which {} reads", path, extension, properties.title()));
    return std::nullopt;
  }
  return path;
}

}  // namespace strahl
