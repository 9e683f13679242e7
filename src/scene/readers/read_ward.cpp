// SPDX-License-Identifier: MIT
// <bsdf type="ward"> of Mitsuba 0.x: Ward's highlight over a diffuse base.
#include <fmt/format.h>

#include "scene/readers/read_material.h"
#include "scene/readers/read_texture.h"

namespace strahl {

namespace {

Ward::Variant read_variant(Properties& properties) {
  const std::string name = properties.string("variant").value_or("balanced");
  if (name == "ward") return Ward::Variant::ward;
  if (name == "ward-duer") return Ward::Variant::ward_duer;
  if (name != "balanced")
    properties.diagnostics().error(
        properties.where("variant"),
        fmt::format("\"{}\" is no variant of ward; there are ward, ward-duer and balanced", name));
  return Ward::Variant::balanced;
}

}  // namespace

Material read_ward(Properties& properties, SceneBuilder& builder) {
  Ward bsdf;
  bsdf.variant = read_variant(properties);
  bsdf.diffuse_reflectance =
      read_reflectance(properties, builder, "diffuse_reflectance", bsdf.diffuse_reflectance.color);
  bsdf.specular_reflectance =
      read_reflectance(properties, builder, "specular_reflectance", bsdf.specular_reflectance.color);
  const auto read_one = [&](const char* name, const Varying& absent) {
    return properties.has(name) ? read_number(properties, builder, name, absent.color, TextureUse::value) : absent;
  };
  const Varying both = read_one("alpha", bsdf.alpha_u);
  bsdf.alpha_u = read_one("alpha_u", both);
  bsdf.alpha_v = read_one("alpha_v", both);
  Material material;
  material.bsdf = bsdf;
  return material;
}

}  // namespace strahl
