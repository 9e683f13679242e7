// SPDX-License-Identifier: MIT
// The microfacets of rough materials.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "scene/readers/read_parts.h"
#include "scene/readers/read_texture.h"

namespace strahl {
namespace {

MicrofacetKind read_kind(Properties& properties) {
  std::string name = properties.string("distribution").value_or("beckmann");
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  if (name == "ggx") return MicrofacetKind::ggx;
  // Mitsuba 0.x has two more.
  if (name == "as" || name == "phong")
    properties.diagnostics().unknown(
        properties.where("distribution"),
        fmt::format("the distribution \"{}\" is not supported; beckmann takes its place", name));
  else if (name != "beckmann")
    properties.diagnostics().error(properties.where("distribution"),
                                   fmt::format("\"{}\" is no distribution; there are beckmann and ggx", name));
  return MicrofacetKind::beckmann;
}

Varying read_alpha(Properties& properties, SceneBuilder& builder, const char* name) {
  return read_number(properties, builder, name, {0.1, 0.1, 0.1}, TextureUse::quantity);
}

}  // namespace

Microfacets read_microfacets(Properties& properties, SceneBuilder& builder) {
  Microfacets microfacets;
  microfacets.kind = read_kind(properties);
  microfacets.sample_visible = properties.boolean("sample_visible").value_or(true);
  const bool has_u = properties.has("alpha_u"), has_v = properties.has("alpha_v");
  if (!has_u && !has_v) {
    microfacets.alpha_u = microfacets.alpha_v = read_alpha(properties, builder, "alpha");
    return microfacets;
  }
  if (properties.has("alpha") || !has_u || !has_v)
    properties.diagnostics().error(properties.where(has_u ? "alpha_u" : "alpha_v"),
                                   "either alpha or both of alpha_u and alpha_v can be given");
  properties.accept({"alpha"});
  microfacets.alpha_u = read_alpha(properties, builder, "alpha_u");
  microfacets.alpha_v = read_alpha(properties, builder, "alpha_v");
  return microfacets;
}

}  // namespace strahl
