// SPDX-License-Identifier: MIT
// <bsdf type="principled"> and <bsdf type="principledthin">: B. Burley's materials.
#include <cmath>
#include <utility>
#include <vector>

#include "scene/readers/read_material.h"
#include "scene/readers/read_texture.h"

namespace strahl {

namespace {

/// Index of refraction of a surface that reflects 0.08 specular at normal incidence.
double eta_of_specular(double specular) { return 2 / (1 - std::sqrt(0.08 * specular)) - 1; }

/// By eta or specular. What lets light through has an index other than 1, as in Mitsuba.
double read_eta(Properties& properties, bool transmits) {
  if (properties.has("eta") && properties.has("specular"))
    properties.diagnostics().error(properties.where("specular"), "either eta or specular can be given");
  double specular = properties.number("specular").value_or(0.5);
  if (!(specular >= 0 && specular <= 1)) {
    properties.diagnostics().error(properties.where("specular"), "specular must lie in [0, 1]");
    specular = 0.5;
  }
  const double eta = properties.number("eta").value_or(eta_of_specular(transmits && specular == 0 ? 1e-3 : specular));
  return transmits && eta == 1 ? 1.001 : eta;
}

using Values = std::vector<std::pair<const char*, Varying*>>;

void read_values(Properties& properties, SceneBuilder& builder, const Values& values,
                 TextureUse use = TextureUse::number) {
  for (const auto& [name, value] : values) *value = read_number(properties, builder, name, value->color, use);
}

void read_rates(Properties& properties, const std::vector<std::pair<const char*, double*>>& rates) {
  for (const auto& [name, rate] : rates) *rate = properties.number(name).value_or(*rate);
}

bool is_black(const Varying& value) { return value.texture < 0 && value.color == Rgb{0, 0, 0}; }

}  // namespace

Material read_principled(Properties& properties, SceneBuilder& builder) {
  Principled bsdf;
  bsdf.base_color = read_reflectance(properties, builder, "base_color", bsdf.base_color.color);
  read_values(properties, builder,
              {{"roughness", &bsdf.roughness},
               {"anisotropic", &bsdf.anisotropic},
               {"metallic", &bsdf.metallic},
               {"spec_trans", &bsdf.spec_trans},
               {"spec_tint", &bsdf.spec_tint},
               {"sheen", &bsdf.sheen},
               {"sheen_tint", &bsdf.sheen_tint},
               {"flatness", &bsdf.flatness},
               {"clearcoat", &bsdf.clearcoat},
               {"clearcoat_gloss", &bsdf.clearcoat_gloss}});
  bsdf.eta = read_eta(properties, !is_black(bsdf.spec_trans));
  read_rates(properties, {{"main_specular_sampling_rate", &bsdf.main_specular_sampling_rate},
                          {"clearcoat_sampling_rate", &bsdf.clearcoat_sampling_rate},
                          {"diffuse_reflectance_sampling_rate", &bsdf.diffuse_reflectance_sampling_rate}});
  Material material;
  material.bsdf = bsdf;
  return material;
}

Material read_principledthin(Properties& properties, SceneBuilder& builder) {
  PrincipledThin bsdf;
  bsdf.base_color = read_reflectance(properties, builder, "base_color", bsdf.base_color.color);
  read_values(properties, builder,
              {{"roughness", &bsdf.roughness},
               {"anisotropic", &bsdf.anisotropic},
               {"spec_trans", &bsdf.spec_trans},
               {"spec_tint", &bsdf.spec_tint},
               {"sheen", &bsdf.sheen},
               {"sheen_tint", &bsdf.sheen_tint},
               {"flatness", &bsdf.flatness}});
  read_values(properties, builder, {{"diff_trans", &bsdf.diff_trans}, {"eta", &bsdf.eta}}, TextureUse::quantity);
  read_rates(properties, {{"specular_reflectance_sampling_rate", &bsdf.specular_reflectance_sampling_rate},
                          {"specular_transmittance_sampling_rate", &bsdf.specular_transmittance_sampling_rate},
                          {"diffuse_reflectance_sampling_rate", &bsdf.diffuse_reflectance_sampling_rate},
                          {"diffuse_transmittance_sampling_rate", &bsdf.diffuse_transmittance_sampling_rate}});
  Material material;
  material.bsdf = bsdf;
  return material;
}

}  // namespace strahl
