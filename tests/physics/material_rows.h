// SPDX-License-Identifier: MIT
// The parameters with which test_materials.cpp asks every material: its defaults, and harder ones.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "kinds/materials.h"
#include "physics/tiers.h"

namespace strahl::test {

/// Parameters as Bsdf has them.
struct MaterialRow {
  std::vector<double> p;
  bool is_lossless = false;
  double spread = 1;  ///< Least roughness.
  double most = 1;    ///< Of the light, that it may scatter (docs/scene-materials.md).
};

using AnyBsdf = decltype(strahl::Material::bsdf);

/// The slots of the entry with its default parameters; none where no material of the model belongs to it.
template <std::size_t alternative = 0>
std::vector<strahl::MaterialSlot> default_slots(const std::string& entry) {
  if constexpr (alternative < std::variant_size_v<AnyBsdf>) {
    strahl::Material material;
    material.bsdf = std::variant_alternative_t<alternative, AnyBsdf>{};
    const strahl::MaterialFacts facts = strahl::material_facts(material);
    if (facts.kind != entry) return default_slots<alternative + 1>(entry);
    return facts.slots;
  } else {
    return {};
  }
}

/// distribution: 1 GGX; 1 visible normals.
inline std::vector<double> rough_metal(const Triad& eta, const Triad& k, double alpha_u, double alpha_v,
                                       const std::array<double, 2>& distribution) {
  return {1, 1,       1, eta[0], eta[1],          eta[2],          k[0], k[1], k[2], alpha_u, 0,
          0, alpha_v, 0, 0,      distribution[0], distribution[1], 0};
}

/// Of relative index eta.
inline std::vector<double> rough_glass(double eta, double alpha_u, double alpha_v,
                                       const std::array<double, 2>& distribution) {
  return {1, 1, 1, 1, 1, 1, eta, eta, 1, alpha_u, 0, 0, alpha_v, 0, 0, distribution[0], distribution[1], 0};
}

/// With the boundary that the host computes.
inline std::vector<double> rough_plastic(const strahl::RoughPlastic& plastic) {
  strahl::Material material;
  material.bsdf = plastic;
  std::vector<double> reals;
  for (const strahl::MaterialSlot& slot : strahl::material_facts(material).slots)
    reals.insert(reals.end(), slot.reals.begin(), slot.reals.end());
  return reals;
}

inline std::vector<double> rough_plastic(double alpha, bool is_ggx, const strahl::Rgb& diffuse, bool is_nonlinear) {
  strahl::RoughPlastic plastic;
  plastic.plastic.diffuse_reflectance.color = diffuse;
  plastic.plastic.nonlinear = is_nonlinear;
  plastic.microfacets.kind = is_ggx ? strahl::MicrofacetKind::ggx : strahl::MicrofacetKind::beckmann;
  plastic.microfacets.alpha_u.color = plastic.microfacets.alpha_v.color = {alpha, alpha, alpha};
  return rough_plastic(plastic);
}

template <class Bsdf>
MaterialRow row_of(const Bsdf& bsdf, double most) {
  strahl::Material material;
  material.bsdf = bsdf;
  MaterialRow row;
  row.most = most;
  for (const strahl::MaterialSlot& slot : strahl::material_facts(material).slots)
    row.p.insert(row.p.end(), slot.reals.begin(), slot.reals.end());
  return row;
}

inline strahl::Varying grey_value(double value) { return {{value, value, value}}; }

inline std::vector<MaterialRow> principled_rows() {
  strahl::Principled white, coated, metal, glass, sharp;
  white.base_color = grey_value(1);
  white.roughness = grey_value(1);
  coated = white;
  coated.sheen = coated.clearcoat = grey_value(1);
  coated.flatness = grey_value(0.5);
  metal.base_color = {{0.9, 0.5, 0.2}};
  metal.roughness = grey_value(0.8);
  metal.metallic = grey_value(0.8);
  metal.spec_tint = grey_value(0.7);
  metal.anisotropic = grey_value(0.6);
  glass.base_color = {{0.9, 0.5, 0.2}};
  glass.roughness = grey_value(0.7);
  glass.spec_trans = grey_value(0.8);
  glass.metallic = grey_value(0.2);
  glass.eta = 1.4;
  sharp = glass;
  sharp.roughness = grey_value(0.03);
  sharp.clearcoat = sharp.clearcoat_gloss = grey_value(1);
  return {row_of(white, 1.61), row_of(coated, 1.72), row_of(metal, 1), row_of(glass, 1), row_of(sharp, 1.1)};
}

inline std::vector<MaterialRow> principledthin_rows() {
  strahl::PrincipledThin sheet, cloth, pane;
  sheet.base_color = {{0.9, 0.5, 0.2}};
  sheet.roughness = grey_value(0.8);
  sheet.spec_trans = grey_value(0.6);
  sheet.diff_trans = grey_value(0.7);
  sheet.spec_tint = grey_value(0.5);
  sheet.anisotropic = grey_value(0.4);
  cloth.base_color = grey_value(1);
  cloth.diff_trans = cloth.sheen = grey_value(1);
  cloth.flatness = grey_value(0.5);
  pane.spec_trans = grey_value(1);
  pane.roughness = grey_value(0.1);
  return {row_of(sheet, 1), row_of(cloth, 1.2), row_of(pane, 1)};
}

inline const std::map<std::string, std::vector<MaterialRow>>& material_rows() {
  static const std::map<std::string, std::vector<MaterialRow>> of_material{
      {"diffuse", {{{0.8, 0.5, 0.1}}, {{1, 1, 1}, true}, {{0, 0, 0}}}},
      {"conductor",
       {{{0.9, 0.6, 0.3, 0, 0, 0, 1, 1, 1}},
        {{1, 1, 1, 0, 0, 0, 1, 1, 1}, true},
        {{1, 1, 1, 0.2, 0.92, 1.1, 3.91, 2.45, 2.14}}}},
      {"roughconductor",
       {{rough_metal({0.14, 0.38, 1.44}, {3.98, 2.39, 1.6}, 0.5, 0.5, {0, 1})},
        {rough_metal({0, 0, 0}, {1, 1, 1}, 0.3, 0.6, {0, 1})},
        {rough_metal({0, 0, 0}, {1, 1, 1}, 0.4, 0.4, {1, 1})},
        {rough_metal({0, 0, 0}, {1, 1, 1}, 0.7, 0.35, {1, 0})},
        {rough_metal({0, 0, 0}, {1, 1, 1}, 0.5, 0.4, {0, 0})},
        {rough_metal({1.5, 1, 0.01}, {0, 1e-3, 9}, 0.01, 0.01, {1, 1})}}},
      {"roughdielectric",
       {{rough_glass(1.5, 0.5, 0.5, {0, 1})},
        {rough_glass(0.625, 0.4, 0.7, {0, 1})},
        {rough_glass(1.33, 0.3, 0.3, {1, 1})},
        {rough_glass(2.5, 0.5, 0.4, {1, 0})},
        {rough_glass(1.5, 0.01, 0.01, {0, 1})}}},
      {"roughplastic",
       {{rough_plastic(0.4, false, {0.8, 0.5, 0.1}, true)},
        {rough_plastic(0.5, true, {1, 1, 1}, false)},
        {rough_plastic(0.01, false, {1, 1, 1}, true)}}},
      {"phong",
       {{{0.5, 0.3, 0.1, 0.2, 0.2, 0.2, 5, 0, 0, 0.3, 0, 0}},
        {{0, 0, 0, 1, 1, 1, 8, 0, 0, 1, 0, 0}},
        {{0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 1e4, 0, 0, 0.5, 0, 0}, false, 0.001}}},
      {"roughdiffuse",
       {{{0.9, 0.5, 0.1, 0, 0, 0, 0, 0, 0}}, {{0.9, 0.9, 0.5, 1, 0, 0, 0, 0, 0}}, {{1, 1, 1, 0.5, 0, 0, 1, 0, 0}}}},
      {"ward",
       {{{0.3, 0.3, 0.1, 0.6, 0.5, 0.2, 0.4, 0, 0, 0.5, 0, 0, 0, 0, 0, 0.6, 2, 0}},
        {{0, 0, 0, 1, 1, 1, 0.02, 0, 0, 0.3, 0, 0, 0, 0, 0, 1, 2, 0}},
        {{0.3, 0.3, 0.1, 0.6, 0.5, 0.2, 0.4, 0, 0, 0.4, 0, 0, 0, 0, 0, 0.6, 0, 0}, false, 1, 1.5}}},
      {"difftrans", {{{1, 1, 1}, true}}},
      {"principled", principled_rows()},
      {"principledthin", principledthin_rows()},
      {"thindielectric", {{{1, 1, 1, 1, 1, 1, 1.5, 1.5, 1}, true}, {{1, 1, 1, 1, 1, 1, 1, 1, 1}, true}}},
      {"plastic",
       {{{0.8, 0.5, 0.1, 1, 1, 1, 1.5, 0.7, 1, 0.6, 1 / 2.25, 0}}, {{1, 1, 1, 0, 0, 0, 1.33, 0, 0, 0.46, 0.5653, 0}}}},
      {"dielectric",
       {{{1, 1, 1, 1, 1, 1, 1.5, 1.5, 1}, true},
        {{1, 1, 1, 1, 1, 1, 0.625, 0.625, 1}, true},
        {{1, 1, 1, 1, 1, 1, 1, 1, 1}, true},
        {{1, 1, 1, 1, 1, 1, 1.0001, 1.0001, 1}, true},
        {{0.5, 0.75, 1, 0.25, 1, 0.5, 2.5, 2.5, 1}}}},
  };
  return of_material;
}

/// Of a slot: the roughness that it gives a lobe; 1: none.
inline double spread_of(const std::string& slot, double value) {
  if (slot.starts_with("alpha")) return value;
  // Times the least that anisotropy leaves, and of glass in sheets the narrower of two lobes.
  if (slot == "exponent") return std::sqrt(2 / (value + 2));
  if (slot == "roughness") return std::max(0.2 * value * value, 1e-3);
  if (slot == "clearcoat_gloss") return 0.1 - 0.099 * value;
  return 1;
}

inline std::vector<MaterialRow> material_rows_of(const std::string& entry) {
  const std::vector<strahl::MaterialSlot> slots = default_slots(entry);
  std::vector<MaterialRow> all(1);
  for (const strahl::MaterialSlot& slot : slots) all[0].p.insert(all[0].p.end(), slot.reals.begin(), slot.reals.end());
  const auto more = material_rows().find(entry);
  if (more != material_rows().end()) all.insert(all.end(), more->second.begin(), more->second.end());
  for (MaterialRow& row : all)
    for (std::size_t i = 0; i < slots.size(); ++i)
      row.spread = std::min(row.spread, spread_of(slots[i].name, row.p.at(3 * i)));
  return all;
}

}  // namespace strahl::test
