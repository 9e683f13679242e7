// SPDX-License-Identifier: MIT
// The lobes are those of the kernels' own list.
#include "kinds/materials.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace strahl {
namespace {

int lobes_of(const std::string& kind) {
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

MaterialFacts facts(const char* kind, std::vector<MaterialSlot> slots, std::vector<std::string> faults = {}) {
  return {kind, lobes_of(kind), std::move(slots), std::move(faults)};
}

/// Beyond 10^6 what is transmitted, 4 / index at normal incidence, is lost to single precision.
std::vector<std::string> faults_of(const Dielectric& glass) {
  const auto is_index_of_refraction = [](double ior) { return ior >= 1e-6 && ior <= 1e6; };
  if (is_index_of_refraction(glass.int_ior) && is_index_of_refraction(glass.ext_ior) &&
      is_index_of_refraction(glass.int_ior / glass.ext_ior))
    return {};
  return {"int_ior and ext_ior must be from 1e-6 to 1e6, and so must their ratio"};
}

/// The slots stand in the order in which the kernels number them.
struct Facts {
  MaterialFacts operator()(const Diffuse& bsdf) const {
    return facts("diffuse", {slot("reflectance", bsdf.reflectance)});
  }
  MaterialFacts operator()(const Conductor& bsdf) const {
    return facts("conductor", {slot("specular_reflectance", bsdf.reflectance)});
  }
  MaterialFacts operator()(const Dielectric& bsdf) const {
    return facts("dielectric",
                 {slot("specular_reflectance", bsdf.reflectance),
                  slot("specular_transmittance", bsdf.transmittance),
                  {"int_ior", {bsdf.int_ior / bsdf.ext_ior, bsdf.int_ior, bsdf.ext_ior}, -1, false}},
                 faults_of(bsdf));
  }
};

}  // namespace

MaterialFacts material_facts(const Material& material) {
  MaterialFacts facts = std::visit(Facts{}, material.bsdf);
  facts.is_twosided = material.twosided && !facts.has_lobe(lobes::LOBE_TRANSMIT);
  return facts;
}

bool transmits(const Material& material) { return material_facts(material).has_lobe(lobes::LOBE_TRANSMIT); }

bool has_lobe(const Scene& scene, int lobe) {
  return std::any_of(scene.materials.begin(), scene.materials.end(),
                     [&](const Material& material) { return material_facts(material).has_lobe(lobe); });
}

}  // namespace strahl
