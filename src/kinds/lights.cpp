// SPDX-License-Identifier: MIT
#include "kinds/lights.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "kinds/upload_frame.h"

namespace strahl::kinds {
namespace {

using Faults = std::vector<std::string>;

void require(Faults& faults, bool holds, const char* fault) {
  if (!holds) faults.emplace_back(fault);
}

void require_light(Faults& faults, const Rgb& c, const char* what) {
  for (const double x : {c.r, c.g, c.b})
    if (!(std::isfinite(x) && x >= 0)) {
      faults.push_back(fmt::format("the {} must be finite and not negative", what));
      return;
    }
  // What the film and a picture's floats hold, in every tier.
  constexpr double most = std::numeric_limits<float>::max();
  if (std::max({c.r, c.g, c.b}) > most)
    faults.push_back(fmt::format("the {} must be at most {:.3g}, the largest float", what, most));
}

/// facts; reals, faults and glows as in lights.h.
template <typename Emitter>
struct Row;

template <>
struct Row<PointLight> {
  static constexpr LightFacts facts{.entry = "point", .is_delta = true};
  static std::vector<double> reals(const PointLight& light, const UploadFrame& frame) {
    const Vec3 p = frame.point(light.position);
    const double area = frame.scale * frame.scale;
    return {p.x, p.y, p.z, area * light.intensity.r, area * light.intensity.g, area * light.intensity.b};
  }
  static bool glows(const PointLight&) { return false; }
  static void check(const PointLight& light, Faults& faults) {
    require(faults, is_finite(light.position), "the position must be finite");
    require_light(faults, light.intensity, "intensity");
  }
};

template <>
struct Row<DirectionalLight> {
  static constexpr LightFacts facts{.entry = "directional", .is_delta = true};
  static std::vector<double> reals(const DirectionalLight& light, const UploadFrame&) {
    const Vec3 d = normalized(light.direction);
    return {d.x, d.y, d.z, light.irradiance.r, light.irradiance.g, light.irradiance.b};
  }
  static bool glows(const DirectionalLight&) { return false; }
  static void check(const DirectionalLight& light, Faults& faults) {
    require(faults, is_finite(light.direction) && light.direction != Vec3{},
            "the direction must be finite and not zero");
    require_light(faults, light.irradiance, "irradiance");
  }
};

template <>
struct Row<ConstantLight> {
  static constexpr LightFacts facts{.entry = "constant", .is_background = true};
  static std::vector<double> reals(const ConstantLight& light, const UploadFrame&) {
    return {light.radiance.r, light.radiance.g, light.radiance.b};
  }
  static bool glows(const ConstantLight& light) {
    return light.radiance.r > 0 || light.radiance.g > 0 || light.radiance.b > 0;
  }
  static void check(const ConstantLight& light, Faults& faults) { require_light(faults, light.radiance, "radiance"); }
};

/// ask(row, emitter) of the light's kind.
template <typename Ask>
decltype(auto) of_kind(const Light& light, Ask ask) {
  return std::visit(
      [&]<typename Emitter>(const Emitter& emitter) -> decltype(auto) { return ask(Row<Emitter>{}, emitter); },
      light.emitter);
}

}  // namespace

const LightFacts& light(const Light& light) {
  return of_kind(light, [](auto row, const auto&) -> const LightFacts& { return decltype(row)::facts; });
}

std::vector<double> light_reals(const Light& light, const UploadFrame& frame) {
  return of_kind(light, [&](auto row, const auto& emitter) { return row.reals(emitter, frame); });
}

bool light_glows(const Light& light) {
  return of_kind(light, [](auto row, const auto& emitter) { return row.glows(emitter); });
}

std::vector<std::string> light_faults(const Light& light) {
  Faults faults;
  of_kind(light, [&](auto row, const auto& emitter) { row.check(emitter, faults); });
  return faults;
}

}  // namespace strahl::kinds
