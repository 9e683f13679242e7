// SPDX-License-Identifier: MIT
// A row for each kind of light other than shapes: the answers to the questions of lights.h. Of lights.cpp alone.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "kinds/faults.h"
#include "kinds/light_reach.h"
#include "kinds/lights.h"
#include "kinds/sphere_mean.h"
#include "kinds/textures.h"
#include "kinds/upload_frame.h"

namespace strahl::kinds {

inline void require_light(Faults& faults, const Rgb& c, const char* what) {
  const auto is_light = [](double x) { return std::isfinite(x) && x >= 0; };
  const bool is_sound = is_light(c.r) && is_light(c.g) && is_light(c.b);
  faults.require(is_sound, "the {} must be finite and not negative", what);
  // The largest value that the film and a picture's floats hold, in every tier.
  constexpr double most = std::numeric_limits<float>::max();
  faults.require(!is_sound || std::max({c.r, c.g, c.b}) <= most, "the {} must be at most {:.3g}, the largest float",
                 what, most);
}

inline void multiply(Rgb& colour, double by) { colour = {by * colour.r, by * colour.g, by * colour.b}; }

/// rounding: of matrices written with six digits.
inline bool is_orthonormal(const std::array<Vec3, 3>& axes, double rounding = 1e-5) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j <= i; ++j)
      if (!(std::fabs(dot(axes[i], axes[j]) - (i == j ? 1 : 0)) <= rounding)) return false;
  return true;
}

/// facts; colour, the member that light_colour() returns; the other questions of lights.h.
template <typename Emitter>
struct Row;

template <>
struct Row<PointLight> {
  static constexpr LightFacts facts{.entry = "point", .is_delta = true, .is_alike = true};
  static constexpr auto colour = &PointLight::intensity;
  static std::vector<double> reals(const PointLight& light, const UploadFrame& frame) {
    const Vec3 p = frame.point(light.position);
    const double area = frame.scale * frame.scale;
    return {p.x, p.y, p.z, area * light.intensity.r, area * light.intensity.g, area * light.intensity.b};
  }
  static void reach(LightReach& reach, const PointLight& light, const UploadFrame& frame) {
    reach.intensity = frame.scale * frame.scale * luminance(light.intensity);
    reach.power = 4 * std::numbers::pi * reach.intensity;
    reach.extent.add(frame.point(light.position));
  }
  static void move(PointLight& light, const MapVec3& point) { light.position = point(light.position); }
  static void scale(PointLight& light, double factor) { multiply(light.intensity, factor * factor); }
  static void mirror(PointLight&, const MapVec3&) {}
  static void check(const PointLight& light, Faults& faults) {
    faults.require(is_finite(light.position), "the position must be finite");
    require_light(faults, light.intensity, "intensity");
  }
};

template <>
struct Row<SpotLight> {
  static constexpr LightFacts facts{.entry = "spot", .is_delta = true, .is_alike = true};
  static constexpr auto colour = &SpotLight::intensity;
  static std::vector<double> reals(const SpotLight& light, const UploadFrame& frame) {
    const Vec3 p = frame.point(light.position), axis = normalized(light.axis);
    const double area = frame.scale * frame.scale;
    // Of a cone with a hard edge the largest power of ten that is far from the largest float.
    const double edge = std::min(360 / (light.cutoff_degrees - light.beam_degrees), 1e30);
    const double inverse = 1 / std::tan(light.cutoff_degrees * std::numbers::pi / 180);
    const Vec3 x = inverse * light.x, y = inverse * light.y;
    return {p.x,
            p.y,
            p.z,
            axis.x,
            axis.y,
            axis.z,
            area * light.intensity.r,
            area * light.intensity.g,
            area * light.intensity.b,
            light.cutoff_degrees / 360,
            edge,
            x.x,
            x.y,
            x.z,
            y.x,
            y.y,
            y.z};
  }
  static void reach(LightReach& reach, const SpotLight& light, const UploadFrame& frame) {
    const double a_degree = std::numbers::pi / 180, half = 0.5 * (light.beam_degrees + light.cutoff_degrees);
    reach.intensity = frame.scale * frame.scale * luminance(light.intensity);
    reach.power = 2 * std::numbers::pi * (1 - std::cos(a_degree * half)) * reach.intensity;
    reach.extent.add(frame.point(light.position));
    reach.axis = normalized(light.axis);
    reach.spread = 0;
    reach.cutoff = a_degree * light.cutoff_degrees;
  }
  static void move(SpotLight& light, const MapVec3& point) { light.position = point(light.position); }
  static void scale(SpotLight& light, double factor) { multiply(light.intensity, factor * factor); }
  static void mirror(SpotLight& light, const MapVec3& flip_x) {
    for (Vec3* axis : {&light.axis, &light.x, &light.y}) *axis = flip_x(*axis);
  }
  static void check(const SpotLight& light, Faults& faults) {
    faults.require(is_finite(light.position), "the position must be finite");
    faults.require(is_finite(light.axis) && light.axis != Vec3{}, "the axis must be finite and not zero");
    require_light(faults, light.intensity, "intensity");
    faults.require(light.cutoff_degrees > 0 && light.cutoff_degrees < 180,
                   "cutoff_angle must lie between 0 and 180 degrees");
    faults.require(light.beam_degrees >= 0 && light.beam_degrees <= light.cutoff_degrees,
                   "beam_width must lie between 0 and cutoff_angle");
    if (light.texture < 0) return;
    faults.require(light.cutoff_degrees < 90, "cutoff_angle of a spot with a texture must be less than 90 degrees");
    faults.require(is_finite(light.x) && is_finite(light.y), "the axes of a spot with a texture must be finite");
    if (!is_finite(light.x) || !is_finite(light.y) || !is_finite(light.axis) || light.axis == Vec3{}) return;
    constexpr double four_digits = 2e-3;  // Which files write, and read_spot keeps.
    faults.require(is_orthonormal({light.x, light.y, normalized(light.axis)}, four_digits),
                   "x and y of a spot with a texture must be unit vectors, perpendicular to its axis and each other");
  }
};

template <>
struct Row<ProjectorLight> {
  static constexpr LightFacts facts{.entry = "projector", .is_delta = true};
  static constexpr auto colour = &ProjectorLight::irradiance;
  static std::vector<double> reals(const ProjectorLight& light, const UploadFrame& frame) {
    const Vec3 p = frame.point(light.position), right = (-1 / light.tan_x) * light.axes[0];
    const Vec3 down = (-1 / light.tan_y) * light.axes[1];
    std::vector<double> values;
    for (const Vec3& v : {p, right, down, light.axes[2]}) values.insert(values.end(), {v.x, v.y, v.z});
    const double factor = std::numbers::pi * frame.scale * frame.scale;
    values.insert(values.end(),
                  {factor * light.irradiance.r, factor * light.irradiance.g, factor * light.irradiance.b});
    return values;
  }
  static void reach(LightReach& reach, const ProjectorLight& light, const UploadFrame& frame) {
    const double middle = std::numbers::pi * frame.scale * frame.scale * luminance(light.irradiance);
    const double corner = std::hypot(1, light.tan_x, light.tan_y);  // One over its cosine from the axis.
    reach.intensity = middle * corner * corner * corner;
    reach.power = 4 * light.tan_x * light.tan_y * middle;
    reach.extent.add(frame.point(light.position));
    reach.axis = light.axes[2];
    reach.spread = 0;
    reach.cutoff = std::acos(1 / corner);
  }
  static void move(ProjectorLight& light, const MapVec3& point) { light.position = point(light.position); }
  static void scale(ProjectorLight& light, double factor) { multiply(light.irradiance, factor * factor); }
  static void mirror(ProjectorLight& light, const MapVec3& flip_x) {
    for (Vec3& axis : light.axes) axis = flip_x(axis);
  }
  static void check(const ProjectorLight& light, Faults& faults) {
    faults.require(is_finite(light.position), "the position must be finite");
    faults.require(is_orthonormal(light.axes),
                   "to_world of a projector must keep right angles; it may turn, move, mirror and scale");
    require_light(faults, light.irradiance, "irradiance");
    const auto is_width = [](double x) { return std::isfinite(x) && x > 0; };
    faults.require(is_width(light.tan_x) && is_width(light.tan_y),
                   "the field of view must lie between 0 and 180 degrees");
  }
};

template <>
struct Row<DirectionalLight> {
  static constexpr LightFacts facts{.entry = "directional", .is_delta = true, .is_far = true};
  static constexpr auto colour = &DirectionalLight::irradiance;
  static std::vector<double> reals(const DirectionalLight& light, const UploadFrame&) {
    const Vec3 d = normalized(light.direction);
    return {d.x, d.y, d.z, light.irradiance.r, light.irradiance.g, light.irradiance.b};
  }
  static void reach(LightReach& reach, const DirectionalLight& light, const UploadFrame&) {
    reach.power = reach.intensity = luminance(light.irradiance);
  }
  static void move(DirectionalLight&, const MapVec3&) {}
  static void scale(DirectionalLight&, double) {}
  static void mirror(DirectionalLight& light, const MapVec3& flip_x) { light.direction = flip_x(light.direction); }
  static void check(const DirectionalLight& light, Faults& faults) {
    faults.require(is_finite(light.direction) && light.direction != Vec3{},
                   "the direction must be finite and not zero");
    require_light(faults, light.irradiance, "irradiance");
  }
};

template <>
struct Row<CollimatedLight> {
  static constexpr LightFacts facts{.entry = "collimated", .is_delta = true, .is_beam = true};
  static constexpr auto colour = &CollimatedLight::power;
  static std::vector<double> reals(const CollimatedLight& light, const UploadFrame& frame) {
    const Vec3 p = frame.point(light.position), d = normalized(light.direction);
    const double area = frame.scale * frame.scale;
    return {p.x, p.y, p.z, d.x, d.y, d.z, area * light.power.r, area * light.power.g, area * light.power.b};
  }
  static void reach(LightReach& reach, const CollimatedLight& light, const UploadFrame& frame) {
    reach.power = reach.intensity = frame.scale * frame.scale * luminance(light.power);
    reach.extent.add(frame.point(light.position));
    reach.axis = normalized(light.direction);
    reach.spread = reach.cutoff = 0;
  }
  static void move(CollimatedLight& light, const MapVec3& point) { light.position = point(light.position); }
  static void scale(CollimatedLight& light, double factor) { multiply(light.power, factor * factor); }
  static void mirror(CollimatedLight& light, const MapVec3& flip_x) { light.direction = flip_x(light.direction); }
  static void check(const CollimatedLight& light, Faults& faults) {
    faults.require(is_finite(light.position), "the position must be finite");
    faults.require(is_finite(light.direction) && light.direction != Vec3{},
                   "the direction must be finite and not zero");
    require_light(faults, light.power, "power");
  }
};

template <>
struct Row<ConstantLight> {
  static constexpr LightFacts facts{.entry = "constant", .is_far = true, .is_background = true, .is_even = true};
  static constexpr auto colour = &ConstantLight::radiance;
  static std::vector<double> reals(const ConstantLight& light, const UploadFrame&) {
    return {light.radiance.r, light.radiance.g, light.radiance.b};
  }
  /// Of a surface that sees half of the sphere.
  static void reach(LightReach& reach, const ConstantLight& light, const UploadFrame&) {
    reach.power = reach.intensity = std::numbers::pi * luminance(light.radiance);
  }
  static void move(ConstantLight&, const MapVec3&) {}
  static void scale(ConstantLight&, double) {}
  static void mirror(ConstantLight&, const MapVec3&) {}
  static void check(const ConstantLight& light, Faults& faults) { require_light(faults, light.radiance, "radiance"); }
};

template <>
struct Row<EnvironmentLight> {
  static constexpr LightFacts facts{.entry = "envmap", .is_far = true, .is_background = true};
  static constexpr auto colour = &EnvironmentLight::scale;
  /// Up to ENVMAP_FLOOR; the rest belongs to its tables (packing/pack_environment.h).
  static std::vector<double> reals(const EnvironmentLight& light, const UploadFrame&) {
    std::vector<double> values;
    for (const Vec3& axis : light.axes) values.insert(values.end(), {axis.x, axis.y, axis.z});
    values.insert(values.end(), {light.scale.r, light.scale.g, light.scale.b});
    return values;
  }
  /// As if it were the same in all directions.
  static void reach(LightReach& reach, const EnvironmentLight& light, const UploadFrame&) {
    const TexelDecoder decoded(*light.texels, light.curve);
    const double mean = sphere_mean(*light.texels, [&](std::size_t n) {
      const std::array<double, 3> c = decoded(n);
      return luminance({light.scale.r * c[0], light.scale.g * c[1], light.scale.b * c[2]});
    });
    reach.power = reach.intensity = std::numbers::pi * mean;
  }
  static void move(EnvironmentLight&, const MapVec3&) {}
  static void scale(EnvironmentLight&, double) {}
  static void mirror(EnvironmentLight& light, const MapVec3& flip_x) {
    for (Vec3& axis : light.axes) axis = flip_x(axis);
  }
  static void check(const EnvironmentLight& light, Faults& faults) {
    faults.require(light.texels && light.texels->width >= 2 && light.texels->height >= 3,
                   "an environment needs an image of at least 2 x 3 texels");
    require_light(faults, light.scale, "scale");
    faults.require(is_orthonormal(light.axes),
                   "to_world of an environment must be a rotation; it may mirror, and scale all axes alike");
  }
};

template <>
struct Row<SunLight> {
  static constexpr LightFacts facts{.entry = "sun", .is_far = true, .is_background = true, .is_sun = true};
  static constexpr auto colour = &SunLight::radiance;
  /// 1 - cos of half the opening.
  static double less(const SunLight& light) {
    const double sine = std::sin(light.aperture_degrees * std::numbers::pi / 720);
    return 2 * sine * sine;
  }
  static std::vector<double> reals(const SunLight& light, const UploadFrame&) {
    const Vec3 d = normalized(light.direction);
    const Rgb& l = light.radiance;
    return {d.x, d.y, d.z, less(light), l.r, l.g, l.b, light.up.x, light.up.y, light.up.z};
  }
  static void reach(LightReach& reach, const SunLight& light, const UploadFrame&) {
    reach.power = reach.intensity = 2 * std::numbers::pi * less(light) * luminance(light.radiance);
  }
  static void move(SunLight&, const MapVec3&) {}
  static void scale(SunLight&, double) {}
  static void mirror(SunLight& light, const MapVec3& flip_x) {
    for (Vec3* axis : {&light.direction, &light.up}) *axis = flip_x(*axis);
  }
  static void check(const SunLight& light, Faults& faults) {
    faults.require(is_finite(light.direction) && light.direction != Vec3{},
                   "the direction must be finite and not zero");
    faults.require(light.aperture_degrees > 0 && light.aperture_degrees <= 90,
                   "the aperture of a sun must be greater than 0 and at most 90 degrees");
    faults.require(is_finite(light.up), "the direction up of a sun must be finite");
    require_light(faults, light.radiance, "radiance");
  }
};

}  // namespace strahl::kinds
