// SPDX-License-Identifier: MIT
// Parameters of Mitsuba 3's sunsky, whose zenith is z, and of Mitsuba 0.x's sky, sun and sunsky, whose zenith is y.
#include "scene/readers/read_sky.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/model/transforms.h"
#include "scene/readers/readers.h"
#include "scene/sky/daylight.h"

namespace strahl {
namespace {

using Emitter = decltype(Light::emitter);

constexpr int sky_width = 512;
constexpr double aperture_of_sun = 0.5358;  // Degrees.

/// What both read. Directions are the model's: east, up, south.
struct Daylight {
  double turbidity = 3;
  Vec3 sun{0, 1, 0};
  std::array<Vec3, 3> axes;  ///< Of the model in the world.
};

DayAndPlace read_day(Properties& properties) {
  DayAndPlace when;
  when.year = properties.integer("year").value_or(when.year);
  when.month = properties.integer_in("month", 1, 12).value_or(when.month);
  when.day = properties.integer_in("day", 1, 31).value_or(when.day);
  when.hour = properties.number("hour").value_or(when.hour) + properties.number("minute").value_or(0) / 60 +
              properties.number("second").value_or(0) / 3600;
  when.latitude = properties.number("latitude").value_or(when.latitude);
  when.longitude = properties.number("longitude").value_or(when.longitude);
  when.timezone = properties.number("timezone").value_or(when.timezone);
  return when;
}

/// As in Mitsuba, which refuses both at once, the direction alone counts.
void warn_of_day_beside_direction(Properties& properties) {
  for (const char* name : {"year", "month", "day", "hour", "minute", "second", "latitude", "longitude", "timezone"})
    if (properties.has(name))
      properties.diagnostics().warning(
          properties.where(name),
          fmt::format("\"{}\" has no effect beside \"sun_direction\", which says where the sun stands; give one of the "
                      "two",
                      name));
}

/// Of a direction in the world, which to_world does not turn.
Vec3 in_model(const Vec3& direction, const std::array<Vec3, 3>& axes) {
  return normalized({dot(direction, axes[0]), dot(direction, axes[1]), dot(direction, axes[2])});
}

Daylight read_daylight(Properties& properties, bool is_y_up) {
  Daylight light;
  const double turbidity = properties.number("turbidity").value_or(light.turbidity);
  if (turbidity >= 1 && turbidity <= 10)
    light.turbidity = turbidity;
  else
    properties.diagnostics().error(properties.where("turbidity"), "turbidity must lie between 1 and 10");
  const Transform to_world = properties.transform("to_world").value_or(Transform{});
  const std::array<Vec3, 3> units{normalized(to_world.column(0)), normalized(to_world.column(1)),
                                  normalized(to_world.column(2))};
  const std::array<Vec3, 3> columns = nearest_axes(units).value_or(units);
  // Mitsuba 3 counts x to the south and y to the west.
  light.axes = is_y_up ? columns : std::array<Vec3, 3>{-columns[1], columns[2], columns[0]};
  const DayAndPlace when = read_day(properties);
  light.sun = direction_of_sun(when);
  if (const std::optional<Vec3> given = properties.vector("sun_direction")) {
    if (*given == Vec3{})
      properties.diagnostics().error(properties.where("sun_direction"), "the direction is zero");
    else
      light.sun = in_model(*given, light.axes);
    warn_of_day_beside_direction(properties);
  }
  if (light.sun.y <= 0)
    properties.diagnostics().warning(properties.where(), "the sun is below the horizon: there is no light of the day");
  // Without a counterpart: light that the ground throws back, how the sky is stretched and stored, limb darkening.
  properties.accept({"albedo", "stretch", "resolution", "extend", "complex_sun", "scale"});
  return light;
}

Rgb multiplied(double factor, const Rgb& c) { return {factor * c.r, factor * c.g, factor * c.b}; }

/// The model's coefficients pass through 0 below its least turbidity, where its sky is no longer one.
Emitter sky_of(Properties& properties, const Daylight& light, double scale) {
  if (light.turbidity < Sky::least_turbidity)
    properties.diagnostics().warning(
        properties.where("turbidity"),
        fmt::format("the model of the sky holds from a turbidity of {} on, which is taken for the sky in place of {}; "
                    "the sun's light is that of the turbidity given",
                    Sky::least_turbidity, light.turbidity));
  EnvironmentLight sky;
  sky.texels = Sky(std::max(light.turbidity, Sky::least_turbidity), light.sun).image(sky_width);
  sky.curve = {TexelCurve::Kind::linear, 1};
  sky.scale = {scale, scale, scale};
  sky.axes = light.axes;
  return sky;
}

/// The same light from a disc of another size; of none at all one direction.
Emitter sun_of(Properties& properties, const Daylight& light, double scale) {
  const double aperture =
      properties.number("sun_aperture").value_or(aperture_of_sun) * properties.number("sun_radius_scale").value_or(1);
  if (!(aperture >= 0 && aperture <= 90))
    properties.diagnostics().error(properties.where(), "the sun's aperture must lie between 0 and 90 degrees");
  const auto [x, y, z] = light.sun;
  const Vec3 direction = x * light.axes[0] + y * light.axes[1] + z * light.axes[2];
  const auto solid_angle = [](double degrees) {
    const double sine = std::sin(degrees * std::numbers::pi / 720);
    return 4 * std::numbers::pi * sine * sine;
  };
  const Rgb radiance = multiplied(scale, radiance_of_sun(light.turbidity, light.sun));
  if (!(aperture > 0)) return DirectionalLight{-direction, multiplied(solid_angle(aperture_of_sun), radiance)};
  const double spread = solid_angle(aperture_of_sun) / solid_angle(aperture);
  return SunLight{direction, aperture, multiplied(spread, radiance), light.axes[1]};
}

}  // namespace

std::optional<Emitter> read_sky(Properties& properties, SceneBuilder&) {
  const Daylight light = read_daylight(properties, true);
  return sky_of(properties, light, properties.number("scale").value_or(1));
}

std::optional<Emitter> read_sun(Properties& properties, SceneBuilder&) {
  const Daylight light = read_daylight(properties, true);
  return sun_of(properties, light, properties.number("scale").value_or(1));
}

std::optional<Emitter> read_sunsky(Properties& properties, SceneBuilder& builder) {
  // Written by the upgrade from 0.x.
  const Daylight light = read_daylight(properties, properties.has_old_rule("is_y_up"));
  const double scale = properties.number("scale").value_or(1);
  const double sun_scale = properties.number("sun_scale").value_or(1), sun = scale * sun_scale;
  if (!(sun_scale >= 0))
    properties.diagnostics().error(properties.where("sun_scale"), "\"sun_scale\" must not be negative");
  if (sun > 0 && light.sun.y > 0)
    builder.scene.lights.push_back(
        {properties.id(), sun_of(properties, light, sun), properties.where(), read_sampling_weight(properties)});
  properties.accept({"sun_aperture", "sun_radius_scale"});
  return sky_of(properties, light, scale * properties.number("sky_scale").value_or(1));
}

}  // namespace strahl
