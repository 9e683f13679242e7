// SPDX-License-Identifier: MIT
// <bsdf type="blendbsdf">: two bsdfs, each for a share of the light; <bsdf type="mixturebsdf"> of Mitsuba 0.x: any
// number of them.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "scene/readers/read_material.h"
#include "scene/readers/read_texture.h"
#include "scene/xml/parse_value.h"

namespace strahl {

namespace {

/// Bsdfs of a mixture, which becomes a chain of blends.
constexpr std::size_t most_mixed = 64;
/// Weights of few digits whose sum is 1 are off by so much at the most.
constexpr double summed_exactly = 1e-6;

}  // namespace

Material read_blend(Properties& properties, SceneBuilder& builder) {
  const std::vector<const XmlElement*> inside = properties.objects("bsdf");
  if (inside.size() != 2) {
    builder.diagnostics.error(properties.where(), fmt::format("{} needs two <bsdf> inside", properties.title()));
    return {};
  }
  Blend blend;
  blend.weight = read_share(properties, builder, "weight", 0.5);
  blend.first = material_index(*inside[0], builder);
  blend.second = material_index(*inside[1], builder);
  Material material;
  material.bsdf = blend;
  return material;
}

/// Weights whose sum is above 1 are scaled to it, as Mitsuba 0.6's `ensureEnergyConservation` does by default; below 1
/// the rest is black.
Material read_mixture(Properties& properties, SceneBuilder& builder) {
  const std::vector<const XmlElement*> inside = properties.objects("bsdf");
  properties.accept({"ensure_energy_conservation"});
  const std::optional<std::string> list = properties.string("weights");
  const std::vector<double> weights =
      list ? parse_numbers(*list).value_or(std::vector<double>{}) : std::vector<double>{};
  const bool is_sound = std::ranges::all_of(weights, [](double weight) { return weight >= 0 && weight <= 1e6; });
  if (inside.empty() || weights.size() != inside.size() || !is_sound || inside.size() > most_mixed) {
    builder.diagnostics.error(properties.where(),
                              fmt::format("{} needs 1 to {} <bsdf> and in \"weights\" a number for each, 0 or more, as "
                                          "\"0.7, 0.3\"; it has {} <bsdf> and {} numbers",
                                          properties.title(), most_mixed, inside.size(), weights.size()));
    return {};
  }
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  Material mixture;
  mixture.where = properties.where();
  mixture.bsdf = Diffuse{{{0, 0, 0}}};
  double behind = sum < 1 - summed_exactly ? 1 - sum : 0;  // The weight of `mixture` so far.
  for (std::size_t i = inside.size(); i-- > 0;) {
    const double all = behind + weights[i];
    if (all == 0) continue;
    const double share = behind / all;
    behind = all;
    if (share == 0) {
      mixture = material_of(*inside[i], builder);
      continue;
    }
    Blend blend;
    blend.weight = {{share, share, share}};
    blend.first = material_index(*inside[i], builder);
    blend.second = add_material(mixture, builder);
    mixture = Material{};
    mixture.where = properties.where();
    mixture.bsdf = blend;
  }
  return mixture;
}

}  // namespace strahl
