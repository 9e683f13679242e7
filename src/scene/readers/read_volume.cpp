// SPDX-License-Identifier: MIT
// Volumes with the parameters of Mitsuba 3.
#include "scene/readers/read_volume.h"

#include <fmt/format.h>

#include "scene/model/transforms.h"
#include "scene/readers/foreign_plugins.h"
#include "scene/readers/read_choice.h"
#include "scene/readers/read_texture.h"

namespace strahl {
namespace {

/// Fills the grid, where it lies, and what is beyond it.
void read_grid(Properties& properties, SceneBuilder& builder, Volume& volume) {
  const std::optional<std::string> path = readable_path(properties, builder);
  if (path) volume.grid = builder.images.read_grid(*path, properties.where("filename"), builder.diagnostics);
  volume.filter = choice<TextureFilter>(properties, "filter_type",
                                        {{"trilinear", TextureFilter::bilinear}, {"nearest", TextureFilter::nearest}},
                                        TextureFilter::bilinear);
  volume.wrap = choice<TextureWrap>(
      properties, "wrap_mode",
      {{"repeat", TextureWrap::repeat}, {"mirror", TextureWrap::mirror}, {"clamp", TextureWrap::clamp}},
      TextureWrap::clamp);
  if (properties.boolean("use_grid_bbox").value_or(false) && volume.grid) {
    const Vec3 low = volume.grid->low, size = volume.grid->high - low;
    volume.world_from_cube =
        volume.world_from_cube * Transform{{{{size.x, 0, 0, low.x}, {0, size.y, 0, low.y}, {0, 0, size.z, low.z}}}};
  }
  // Texels are linear as they are; the largest value is looked up.
  properties.accept({"raw", "max_value", "accel"});
}

}  // namespace

std::optional<Volume> read_volume(Properties& properties, SceneBuilder& builder, const char* name, ColorUse use,
                                  const Rgb& substitute, bool can_vary) {
  const XmlElement* given = properties.peek(name);
  if (given == nullptr || given->tag != "volume") {
    const std::optional<Rgb> value = properties.color(name, use, substitute);
    return value ? std::optional<Volume>(*value) : std::nullopt;
  }
  properties.accept({name});
  Properties inner(*given, builder.ids, builder.diagnostics);
  const bool is_grid = inner.type() == "gridvolume";
  if (is_grid && !can_vary) {
    builder.diagnostics.warning(given->where,
                                fmt::format("a gridvolume belongs to a medium of type heterogeneous; {} keeps its "
                                            "default",
                                            name));
    return {};
  }
  if (!is_grid && inner.type() != "constvolume") {
    builder.diagnostics.unknown(given->where, not_available("volume", inner.type(), {"constvolume", "gridvolume"}) +
                                                  fmt::format("; {} keeps its default", name));
    return {};
  }
  Volume volume = is_grid ? Rgb{1, 1, 1} : inner.color("value", use, substitute).value_or(Rgb{1, 1, 1});
  volume.world_from_cube = inner.transform("to_world").value_or(Transform{});
  if (is_grid) read_grid(inner, builder, volume);
  inner.report_unknown();
  return volume;
}

void make_grid(Volume& volume) {
  if (!volume.grid) volume.grid = std::make_shared<const VolumeGrid>(grid_of_floats(1, 1, 1, 1, {1.0F}));
}

}  // namespace strahl
