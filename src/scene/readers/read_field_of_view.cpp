// SPDX-License-Identifier: MIT
// fov and fov_axis, or focal_length: of cameras and projectors.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "scene/readers/plugin_table.h"
#include "scene/readers/read_parts.h"
#include "scene/xml/parse_value.h"

namespace strahl {

namespace {

const PluginTable<FovAxis>& fov_axes() {
  static const PluginTable<FovAxis> table{{"x", FovAxis::x},
                                          {"y", FovAxis::y},
                                          {"diagonal", FovAxis::diagonal},
                                          {"smaller", FovAxis::smaller},
                                          {"larger", FovAxis::larger}};
  return table;
}

/// Opening angle along the diagonal of 36 mm x 24 mm film, as in Mitsuba.
double diagonal_fov_degrees(double focal_length_mm) {
  return 2 * std::atan(std::hypot(36.0, 24.0) / (2 * focal_length_mm)) * 180 / std::numbers::pi;
}

void read_focal_length(Properties& properties, FieldOfView& fov) {
  fov.axis = FovAxis::diagonal;
  fov.degrees = diagonal_fov_degrees(50);
  const std::optional<std::string> text = properties.string("focal_length");
  if (!text) return;
  const std::size_t unit = text->rfind("mm");
  const std::optional<double> length = parse_number(text->substr(0, unit));
  if (length && std::isfinite(*length) && *length > 0) {
    fov.degrees = diagonal_fov_degrees(*length);
  } else {
    properties.diagnostics().error(properties.where("focal_length"),
                                   fmt::format("\"{}\" is not a focal length such as \"50mm\"", *text));
  }
}

void read_fov_axis(Properties& properties, FieldOfView& fov) {
  const std::optional<std::string> name = properties.string("fov_axis");
  if (!name) return;
  const FovAxis* axis = find_plugin(fov_axes(), lower_case(*name));
  if (axis != nullptr) {
    fov.axis = *axis;
  } else {
    properties.diagnostics().error(properties.where("fov_axis"),
                                   fmt::format("fov_axis \"{}\" is none of x, y, diagonal, smaller, larger{}", *name,
                                               did_you_mean_plugin(fov_axes(), *name)));
  }
}

}  // namespace

FieldOfView read_field_of_view(Properties& properties) {
  FieldOfView fov;
  if (properties.has("fov") && properties.has("focal_length")) {
    properties.accept({"fov", "focal_length", "fov_axis"});
    properties.diagnostics().error(properties.where("focal_length"),
                                   "give either \"fov\" or \"focal_length\", not both");
  } else if (!properties.has("fov")) {
    read_focal_length(properties, fov);
    if (properties.has("fov_axis")) {
      properties.accept({"fov_axis"});
      properties.diagnostics().unknown(
          properties.where("fov_axis"),
          "fov_axis needs \"fov\"; a focal length counts along the diagonal, so it is ignored");
    }
  } else {
    fov.degrees = properties.number("fov").value_or(50);
    if (!(fov.degrees > 0 && fov.degrees < 180))
      properties.diagnostics().error(properties.where("fov"),
                                     fmt::format("fov is {}; it must lie between 0 and 180 degrees", fov.degrees));
    read_fov_axis(properties, fov);
  }
  return fov;
}

}  // namespace strahl
