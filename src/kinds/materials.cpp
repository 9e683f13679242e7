// SPDX-License-Identifier: MIT
// The lobes are those of the kernels' own list.
#include "kinds/materials.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "kinds/principled_lobes.h"
#include "kinds/rough_boundary.h"

namespace strahl {
namespace {

int lobes_of_kind(const std::string& kind) {
  using namespace lobes;
#define MATERIAL(name, reals, its_lobes) \
  if (kind == #name) return its_lobes;
#include "../../cl/materials/materials.def"
#undef MATERIAL
  throw std::logic_error("materials.def has no " + kind);
}

MaterialSlot slot(const char* name, const Reflectance& share) {
  return {name, {share.color.r, share.color.g, share.color.b}, share.texture};
}

MaterialSlot value_slot(const char* name, const Varying& value) {
  MaterialSlot made = slot(name, value);
  made.is_share = false;
  return made;
}

/// A share of rays, which is no colour.
MaterialSlot share_slot(const char* name, const Reflectance& share) {
  MaterialSlot made = slot(name, share);
  made.is_colour = false;
  return made;
}

MaterialFacts facts(const char* kind, std::vector<MaterialSlot> slots, std::vector<std::string> faults = {}) {
  return {.kind = kind,
          .lobes = lobes_of_kind(kind),
          .slots = std::move(slots),
          .opacity = {},
          .flags = {},
          .faults = std::move(faults),
          .nested = {}};
}

bool is_at_least(double least, const Rgb& c) { return is_finite(c) && c.r >= least && c.g >= least && c.b >= least; }

/// From 0 to 10^6: the fourth powers of more are lost to single precision.
bool is_within_limits(const Rgb& c) { return is_at_least(0, c) && std::max({c.r, c.g, c.b}) <= 1e6; }

/// Whether it reflects everything at every angle.
bool is_ideal(const MetalIndex& index) { return index.eta.texture < 0 && index.eta.color == Rgb{0, 0, 0}; }

void require_index(const MetalIndex& index, MaterialFacts& facts) {
  if (!is_within_limits(index.eta.color) || !is_within_limits(index.k.color))
    facts.faults.emplace_back("eta and k must be from 0 to 1e6");
}

void add_microfacets(const Microfacets& microfacets, MaterialFacts& facts) {
  const bool is_ggx = microfacets.kind == MicrofacetKind::ggx;
  facts.slots.push_back(value_slot("alpha_u", microfacets.alpha_u));
  facts.slots.push_back(value_slot("alpha_v", microfacets.alpha_v));
  facts.slots.push_back({"distribution", {is_ggx ? 1.0 : 0.0, microfacets.sample_visible ? 1.0 : 0.0, 0}, -1, false});
  facts.flags.emplace_back(is_ggx ? "GGX" : "BECKMANN");
  const Varying &u = microfacets.alpha_u, &v = microfacets.alpha_v;
  facts.has_along = u.color != v.color || u.texture != v.texture;
  if (!is_within_limits(microfacets.alpha_u.color) || !is_within_limits(microfacets.alpha_v.color))
    facts.faults.emplace_back("alpha must be from 0 to 1e6");
}

/// Beyond 10^6 what is transmitted, 4 / index at normal incidence, is lost to single precision.
std::vector<std::string> index_faults(double int_ior, double ext_ior) {
  const auto is_index_of_refraction = [](double ior) { return ior >= 1e-6 && ior <= 1e6; };
  if (is_index_of_refraction(int_ior) && is_index_of_refraction(ext_ior) && is_index_of_refraction(int_ior / ext_ior))
    return {};
  return {"int_ior and ext_ior must be from 1e-6 to 1e6, and so must their ratio"};
}

/// Slots and faults of glass of any kind.
MaterialFacts glass_facts(const char* kind, const Dielectric& glass) {
  return facts(kind,
               {slot("specular_reflectance", glass.reflectance),
                slot("specular_transmittance", glass.transmittance),
                {"int_ior", {glass.int_ior / glass.ext_ior, glass.int_ior, glass.ext_ior}, -1, false}},
               index_faults(glass.int_ior, glass.ext_ior));
}

double mean(const Reflectance& share) { return (share.color.r + share.color.g + share.color.b) / 3; }

/// inner: the share of diffuse light that the boundary reflects from within.
MaterialFacts plastic_facts(const char* kind, const Plastic& plastic, double inner) {
  const double eta = plastic.int_ior / plastic.ext_ior, specular = mean(plastic.specular_reflectance);
  const double both = specular + mean(plastic.diffuse_reflectance), weight = both > 0 ? specular / both : 0.5;
  return facts(kind,
               {slot("diffuse_reflectance", plastic.diffuse_reflectance),
                slot("specular_reflectance", plastic.specular_reflectance),
                {"int_ior", {eta, weight, plastic.nonlinear ? 1.0 : 0.0}, -1, false},
                {"inner", {inner, 1 / (eta * eta), 0}, -1, false}},
               index_faults(plastic.int_ior, plastic.ext_ior));
}

bool is_black(const Reflectance& share) { return share.texture < 0 && share.color == Rgb{0, 0, 0}; }

/// Numbers up to a limit, as the kernels read them, after the slots that are there.
void add_numbers(const std::vector<std::pair<const char*, const Varying*>>& numbers, double most,
                 MaterialFacts& facts) {
  for (const auto& [name, value] : numbers) {
    facts.slots.push_back(value_slot(name, *value));
    if (!is_at_least(0, value->color) || std::max({value->color.r, value->color.g, value->color.b}) > most)
      facts.faults.push_back(std::string(name) + (most == 1 ? " must lie in [0, 1]" : " must lie in [0, 2]"));
  }
}

/// Each must be finite and not negative, and one of them above 0.
void require_rates(const std::vector<double>& rates, MaterialFacts& facts) {
  double sum = 0;
  for (const double rate : rates) sum += rate >= 0 ? rate : std::nan("");
  if (!std::isfinite(sum) || sum == 0)
    facts.faults.emplace_back("sampling rates must be finite, not negative, and not all 0");
}

/// What a highlight and a diffuse base reflect; the chance that the highlight is drawn.
struct Parts {
  Reflectance diffuse, specular;
  double chance;
};

/// Together at most what is received. Beside a texture packing scales, which knows how bright that is.
Parts parts_of(Reflectance diffuse, Reflectance specular) {
  Rgb &d = diffuse.color, &s = specular.color;
  if (diffuse.texture < 0 && specular.texture < 0) {
    const double scale = scale_of_parts({d.r + s.r, d.g + s.g, d.b + s.b});
    d = {scale * d.r, scale * d.g, scale * d.b};
    s = {scale * s.r, scale * s.g, scale * s.b};
  }
  const double both = mean(specular) + mean(diffuse);
  return {diffuse, specular, both > 0 ? mean(specular) / both : 0.5};
}

MaterialFacts phong_facts(const Phong& phong) {
  const Parts parts = parts_of(phong.diffuse_reflectance, phong.specular_reflectance);
  MaterialFacts found = facts("phong", {slot("diffuse_reflectance", parts.diffuse),
                                        slot("specular_reflectance", parts.specular),
                                        value_slot("exponent", phong.exponent),
                                        {"chance", {parts.chance, 0, 1}, -1, false}});
  found.scale_slot = 3;
  if (!is_at_least(0, phong.exponent.color)) found.faults.emplace_back("exponent must be finite and not negative");
  return found;
}

MaterialFacts ward_facts(const Ward& ward) {
  const Parts parts = parts_of(ward.diffuse_reflectance, ward.specular_reflectance);
  MaterialFacts found =
      facts("ward", {slot("diffuse_reflectance", parts.diffuse), slot("specular_reflectance", parts.specular)});
  add_microfacets({MicrofacetKind::beckmann, ward.alpha_u, ward.alpha_v, false}, found);
  found.slots.push_back({"variant", {parts.chance, static_cast<double>(ward.variant), 1}, -1, false});
  found.scale_slot = 5;
  return found;
}

constexpr double largest_eta = 1e3;

MaterialFacts principled_facts(const Principled& bsdf) {
  MaterialFacts found = facts("principled", {slot("base_color", bsdf.base_color)});
  add_numbers({{"roughness", &bsdf.roughness},
               {"anisotropic", &bsdf.anisotropic},
               {"metallic", &bsdf.metallic},
               {"spec_trans", &bsdf.spec_trans},
               {"spec_tint", &bsdf.spec_tint},
               {"sheen", &bsdf.sheen},
               {"sheen_tint", &bsdf.sheen_tint},
               {"flatness", &bsdf.flatness},
               {"clearcoat", &bsdf.clearcoat},
               {"clearcoat_gloss", &bsdf.clearcoat_gloss}},
              1, found);
  const std::array<double, 3> rates{bsdf.main_specular_sampling_rate, bsdf.clearcoat_sampling_rate,
                                    bsdf.diffuse_reflectance_sampling_rate};
  found.slots.push_back({"eta", {bsdf.eta, 0, 0}, -1, false});
  found.slots.push_back({"sampling_rate", rates, -1, false});
  require_rates({rates.begin(), rates.end()}, found);
  found.flags.emplace_back("GGX");
  found.has_along = !is_black(bsdf.anisotropic);
  found.draws_all = kinds::draws_all_lobes(bsdf);
  if (is_black(bsdf.spec_trans)) found.lobes &= ~lobes::LOBE_TRANSMIT;
  if (!(bsdf.eta >= 1 / largest_eta && bsdf.eta <= largest_eta))
    found.faults.emplace_back("eta must be from 0.001 to 1000");
  if (bsdf.eta == 1 && !is_black(bsdf.spec_trans))
    found.faults.emplace_back("eta of what lets light through must differ from 1");
  return found;
}

MaterialFacts principledthin_facts(const PrincipledThin& bsdf) {
  MaterialFacts found = facts("principledthin", {slot("base_color", bsdf.base_color)});
  add_numbers({{"roughness", &bsdf.roughness},
               {"anisotropic", &bsdf.anisotropic},
               {"spec_trans", &bsdf.spec_trans},
               {"spec_tint", &bsdf.spec_tint},
               {"sheen", &bsdf.sheen},
               {"sheen_tint", &bsdf.sheen_tint},
               {"flatness", &bsdf.flatness}},
              1, found);
  add_numbers({{"diff_trans", &bsdf.diff_trans}}, 2, found);
  found.slots.push_back(value_slot("eta", bsdf.eta));
  found.slots.push_back({"sampling_rate",
                         {bsdf.specular_reflectance_sampling_rate, bsdf.specular_transmittance_sampling_rate,
                          bsdf.diffuse_reflectance_sampling_rate},
                         -1,
                         false});
  found.slots.push_back({"sampling_rate", {bsdf.diffuse_transmittance_sampling_rate, 0, 0}, -1, false});
  require_rates({bsdf.specular_reflectance_sampling_rate, bsdf.specular_transmittance_sampling_rate,
                 bsdf.diffuse_reflectance_sampling_rate, bsdf.diffuse_transmittance_sampling_rate},
                found);
  found.flags.emplace_back("GGX");
  found.has_along = !is_black(bsdf.anisotropic);
  found.draws_all = kinds::draws_all_lobes(bsdf);
  if (is_black(bsdf.spec_trans) && is_black(bsdf.diff_trans)) found.lobes &= ~lobes::LOBE_TRANSMIT;
  const Rgb& eta = bsdf.eta.color;
  if (!is_at_least(1 / largest_eta, eta) || std::max({eta.r, eta.g, eta.b}) > largest_eta)
    found.faults.emplace_back("eta must be from 0.001 to 1000");
  return found;
}

/// The slots stand in the order in which the kernels number them.
struct Facts {
  MaterialFacts operator()(const Diffuse& bsdf) const {
    return facts("diffuse", {slot("reflectance", bsdf.reflectance)});
  }
  MaterialFacts operator()(const Conductor& bsdf) const {
    MaterialFacts metal = facts("conductor", {slot("specular_reflectance", bsdf.reflectance),
                                              value_slot("eta", bsdf.index.eta), value_slot("k", bsdf.index.k)});
    metal.is_metal = true;
    if (!is_ideal(bsdf.index)) metal.flags.emplace_back("METAL");
    require_index(bsdf.index, metal);
    return metal;
  }
  MaterialFacts operator()(const RoughConductor& bsdf) const {
    MaterialFacts metal = facts("roughconductor", {slot("specular_reflectance", bsdf.reflectance),
                                                   value_slot("eta", bsdf.index.eta), value_slot("k", bsdf.index.k)});
    metal.is_metal = true;
    require_index(bsdf.index, metal);
    add_microfacets(bsdf.microfacets, metal);
    return metal;
  }
  MaterialFacts operator()(const Dielectric& bsdf) const {
    MaterialFacts glass = glass_facts("dielectric", bsdf);
    glass.is_boundary = true;
    return glass;
  }
  MaterialFacts operator()(const RoughDielectric& bsdf) const {
    MaterialFacts glass = glass_facts("roughdielectric", bsdf.glass);
    add_microfacets(bsdf.microfacets, glass);
    glass.is_boundary = true;
    if (bsdf.glass.int_ior == bsdf.glass.ext_ior)
      glass.faults.emplace_back("int_ior and ext_ior of a roughdielectric must differ");
    return glass;
  }
  MaterialFacts operator()(const ThinDielectric& bsdf) const { return glass_facts("thindielectric", bsdf.glass); }
  MaterialFacts operator()(const Plastic& bsdf) const {
    return plastic_facts("plastic", bsdf, kinds::smooth_inner_reflectance(bsdf.int_ior / bsdf.ext_ior));
  }
  MaterialFacts operator()(const RoughPlastic& bsdf) const {
    const Microfacets& microfacets = bsdf.microfacets;
    const double eta = bsdf.plastic.int_ior / bsdf.plastic.ext_ior, alpha = microfacets.alpha_u.color.r;
    const bool is_possible = std::isfinite(eta) && eta > 0 && std::isfinite(alpha) && alpha >= 0;
    const auto boundary = is_possible ? kinds::rough_boundary(microfacets.kind, alpha, eta) : kinds::RoughBoundary{};
    MaterialFacts plastic = plastic_facts("roughplastic", bsdf.plastic, boundary.inner);
    plastic.slots.back().reals[2] = boundary.soft;
    add_microfacets(microfacets, plastic);
    plastic.slots.back().reals[2] = boundary.spread;
    const std::array<double, 9>& t = boundary.through;
    for (std::size_t i = 0; i < t.size(); i += 3)
      plastic.slots.push_back({"through", {t[i], t[i + 1], t[i + 2]}, -1, false});
    if (plastic.has_along || microfacets.alpha_u.texture >= 0)
      plastic.faults.emplace_back("the roughness of a roughplastic must be one number");
    return plastic;
  }
  MaterialFacts operator()(const Phong& bsdf) const { return phong_facts(bsdf); }
  MaterialFacts operator()(const Ward& bsdf) const { return ward_facts(bsdf); }
  MaterialFacts operator()(const RoughDiffuse& bsdf) const {
    MaterialFacts found =
        facts("roughdiffuse", {slot("reflectance", bsdf.reflectance),
                               value_slot("deviation", bsdf.alpha),
                               {"use_fast_approx", {bsdf.use_fast_approx ? 1.0 : 0.0, 0, 0}, -1, false}});
    if (!is_at_least(0, bsdf.alpha.color)) found.faults.emplace_back("alpha must be finite and not negative");
    return found;
  }
  MaterialFacts operator()(const DiffTrans& bsdf) const {
    return facts("difftrans", {slot("transmittance", bsdf.transmittance)});
  }
  MaterialFacts operator()(const Principled& bsdf) const { return principled_facts(bsdf); }
  MaterialFacts operator()(const PrincipledThin& bsdf) const { return principledthin_facts(bsdf); }
  MaterialFacts operator()(const Blend& blend) const {
    MaterialFacts facts;
    facts.kind = "blendbsdf";
    facts.slots = {share_slot("weight", blend.weight)};
    facts.flags = {"BLEND"};
    facts.nested = {blend.first, blend.second};
    return facts;
  }
  MaterialFacts operator()(const Relief& relief) const {
    const bool has_heights = relief.kind == Relief::Kind::heights;
    MaterialFacts facts;
    facts.kind = has_heights ? "bumpmap" : "normalmap";
    MaterialSlot options{"scale",
                         {relief.flip_invalid_normals ? 1.0 : 0.0,
                          (relief.use_shadowing_function ? 1.0 : 0.0) + (has_heights ? 2.0 : 0.0), relief.scale},
                         -1,
                         false};
    options.has_length = true;
    facts.slots = {value_slot("map", relief.map), options};
    facts.flags = {"RELIEF"};
    facts.nested = {relief.nested};
    facts.has_along = true;
    // Slopes of far more overflow single precision, where surfaces are flat.
    if (!(std::abs(relief.scale) <= 1e12)) facts.faults.emplace_back("scale must be from -1e12 to 1e12");
    if (!is_finite(relief.map.color)) facts.faults.emplace_back("normalmap must be finite");
    return facts;
  }
  MaterialFacts operator()(const Coat& coat) const {
    const Rgb& s = coat.sigma_a.color;
    const auto left = [&](double absorbed) { return std::exp(-2 * absorbed * coat.thickness); };
    // As often as Mitsuba draws it.
    const double weight = 1 / (1 + (left(s.r) + left(s.g) + left(s.b)) / 3);
    MaterialFacts facts;
    facts.kind = "coating";
    facts.lobes = lobes::LOBE_DELTA | lobes::LOBE_REFLECT;
    facts.slots = {slot("specular_reflectance", coat.specular_reflectance),
                   value_slot("sigma_a", coat.sigma_a),
                   {"int_ior", {coat.int_ior / coat.ext_ior, weight, coat.thickness}, -1, false}};
    facts.flags = {"COAT"};
    facts.faults = index_faults(coat.int_ior, coat.ext_ior);
    facts.nested = {coat.nested};
    facts.is_coat = true;
    if (!std::isfinite(coat.thickness) || coat.thickness < 0)
      facts.faults.emplace_back("thickness must be finite and not negative");
    if (!is_at_least(0, s)) facts.faults.emplace_back("sigma_a must be finite and not negative");
    return facts;
  }
};

}  // namespace

double scale_of_parts(const Rgb& together) {
  const double most = std::max({together.r, together.g, together.b});
  return most > 1 ? 0.99 / most : 1;
}

MaterialFacts material_facts(const Material& material) {
  MaterialFacts facts = std::visit(Facts{}, material.bsdf);
  if (material.opacity) facts.opacity = share_slot("opacity", *material.opacity);
  facts.is_twosided = material.twosided && !facts.has_lobe(lobes::LOBE_TRANSMIT);
  return facts;
}

}  // namespace strahl
