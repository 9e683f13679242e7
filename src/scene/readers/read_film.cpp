// SPDX-License-Identifier: MIT
// <film>: size, crop window, reconstruction filter. File formats are chosen by -o, so theirs are accepted.
#include <fmt/format.h>

#include <algorithm>

#include "scene/readers/foreign_plugins.h"
#include "scene/readers/readers.h"
#include "scene/xml/properties.h"

namespace strahl {

namespace {

void read_crop(Properties& properties, Film& film) {
  const char* names[] = {"crop_offset_x", "crop_offset_y", "crop_width", "crop_height"};
  const bool is_cropped = std::any_of(std::begin(names), std::end(names), [&](auto n) { return properties.has(n); });
  if (!is_cropped) return;
  const int x = properties.integer_in("crop_offset_x", 0, film.width - 1).value_or(0);
  const int y = properties.integer_in("crop_offset_y", 0, film.height - 1).value_or(0);
  // Without a size the window is the whole picture, as in Mitsuba; beside an offset it then does not fit.
  const int width = properties.integer_in("crop_width", 1, Film::largest_size).value_or(film.width);
  const int height = properties.integer_in("crop_height", 1, Film::largest_size).value_or(film.height);
  const char* wide = properties.has("crop_width") ? "crop_width" : "crop_offset_x";
  const char* high = properties.has("crop_height") ? "crop_height" : "crop_offset_y";
  if (x + width > film.width)
    properties.diagnostics().error(
        properties.where(wide),
        fmt::format("the crop window ends at x = {}, beyond the width {}", x + width, film.width));
  if (y + height > film.height)
    properties.diagnostics().error(
        properties.where(high),
        fmt::format("the crop window ends at y = {}, beyond the height {}", y + height, film.height));
  film.crop = Window{x, y, x + width, y + height};
}

}  // namespace

Film read_film(const XmlElement& element, SceneBuilder& builder) {
  Properties properties(element, builder.ids, builder.diagnostics);
  // Mitsuba 0.x has one for each format, and one that writes tiles.
  const std::string_view type = properties.type();
  const bool is_old = type == "ldrfilm" || type == "mfilm" || type == "tiledhdrfilm";
  if (type != "hdrfilm" && !is_old)
    builder.diagnostics.unknown(element.where,
                                fmt::format("{}; it is read as hdrfilm", not_available("film", type, {"hdrfilm"})));
  Film film;
  film.where = element.where;
  film.width = properties.integer_in("width", 1, Film::largest_size).value_or(film.width);
  film.height = properties.integer_in("height", 1, Film::largest_size).value_or(film.height);
  read_crop(properties, film);
  const std::vector<const XmlElement*> filters = properties.objects("rfilter");
  if (!filters.empty()) film.filter = read_filter(*filters.front(), builder);
  if (filters.size() > 1) builder.diagnostics.error(filters[1]->where, "a film has one <rfilter>");
  properties.accept({"file_format", "pixel_format", "component_format", "sample_border", "compensate", "banner",
                     "attach_log", "high_quality_edges", "gamma"});
  if (is_old) properties.accept({"filename", "digits", "variable"});
  properties.report_unknown();
  return film;
}

}  // namespace strahl
