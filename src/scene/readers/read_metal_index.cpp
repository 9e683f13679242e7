// SPDX-License-Identifier: MIT
// The index of refraction of metals: by name, or by eta and k. Mitsuba 0.x has ext_eta as well, the index of what is
// outside, by which both are divided; and there eta and k may stand beside a name.
#include <fmt/format.h>

#include "did_you_mean.h"
#include "scene/readers/metals.h"
#include "scene/readers/read_parts.h"
#include "scene/readers/read_texture.h"
#include "scene/xml/parse_value.h"

namespace strahl {
namespace {

Varying divided(const Varying& value, double by) {
  return {{value.color.r / by, value.color.g / by, value.color.b / by}, value.texture};
}

}  // namespace

MetalIndex read_metal_index(Properties& properties, SceneBuilder& builder) {
  std::string name = properties.string("material").value_or("none");
  // Written by the upgrade from 0.x, where none may be in capitals, too.
  const bool is_old = properties.has_old_rule("eta_and_k_replace_named");
  if (is_old && lower_case(name) == "none") name = "none";
  const bool is_named = name != "none", has_values = properties.has("eta") || properties.has("k");
  if (is_named && has_values && !is_old)
    properties.diagnostics().error(properties.where("material"), "either a material or eta and k can be given");
  const std::optional<MetalIndex> named = metal_index(name);
  if (!named)
    properties.diagnostics().error(properties.where("material"),
                                   fmt::format("\"{}\" is no metal that strahl knows{}; eta and k will do", name,
                                               did_you_mean(name, metal_names())));
  MetalIndex index = named.value_or(MetalIndex{});
  index.eta = read_varying(properties, builder, "eta", index.eta.color);
  index.k = read_varying(properties, builder, "k", index.k.color);
  const double outside = read_index_of_refraction(properties, "ext_eta", 1);
  if (outside == 1) return index;
  if (index.eta.texture >= 0 || index.k.texture >= 0)
    properties.diagnostics().unknown(properties.where("ext_eta"), "ext_eta has no effect on textures");
  return {divided(index.eta, outside), divided(index.k, outside)};
}

}  // namespace strahl
