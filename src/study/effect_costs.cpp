// SPDX-License-Identifier: MIT
#include "study/effect_costs.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "kinds/integrators.h"
#include "packing/cl_layout.h"
#include "program/disabled.h"
#include "program/features.h"
#include "render/median.h"

namespace strahl {
namespace {

bool is_black(const Image& image) {
  return std::all_of(image.data.begin(), image.data.end(), [](float value) { return value == 0; });
}

/// Settings without the effect; none where nothing could be rendered, with the reason.
std::optional<RenderSettings> without(const std::string& name, RenderSettings settings, std::string& why) {
  if (name == "AOV") {
    settings.aovs.clear();
    return settings;
  }
  if (name == "ERROR_SUMS") {
    settings.estimate_error = false;
    return settings;
  }
  why = needed_because(name);
  if (!why.empty()) return std::nullopt;
  settings.disabled.insert(name);
  return settings;
}

bool has_shapes(const Features& features) { return !features.entries.at("shapes").empty(); }

/// A film has sub-sums from so many samples on; the time of fewer says nothing of ERROR_SUMS.
constexpr int least_summed = layout::FILM_SUBSUMS;

EffectCost cost_of(const std::string& name, const VariantStudy& study, const VariantTimes& less) {
  const VariantTimes& all = study.variants[0];
  EffectCost cost;
  cost.program_bytes = static_cast<double>(all.bytes) - static_cast<double>(less.bytes);
  cost.build_seconds = all.build() - less.build();
  cost.private_bytes = static_cast<double>(all.private_bytes) - static_cast<double>(less.private_bytes);
  if (is_black(less.color) && !is_black(all.color)) {
    cost.frame_needed = "the picture would be black";
    return cost;
  }
  if (name == "ERROR_SUMS" && study.spp < least_summed) {
    cost.frame_needed = fmt::format("fewer than {} samples a pixel: no sub-sums", least_summed);
    return cost;
  }
  std::vector<double> differences;
  for (std::size_t i = 0; i < less.kernel_seconds.size(); ++i)
    differences.push_back(less.first_seconds[i] - less.kernel_seconds[i]);
  cost.kernel_seconds = median(differences);
  cost.kernel_share = 1 - less.ratio();
  return cost;
}

}  // namespace

EffectCosts measure_effects(const Device& device, const Scene& scene, const RenderSettings& settings,
                            const VariantRounds& rounds, const StudyProgress& progress,
                            const std::set<std::string>& chosen) {
  EffectCosts costs;
  std::vector<RenderSettings> variants{settings};
  variants[0].cached_program = false;
  std::vector<std::string> names{""};
  for (const FeatureReport& row : features_of(scene, settings).report) {
    if (!row.on || (!chosen.empty() && !chosen.contains(row.name))) continue;
    EffectCost& cost = costs.effects[row.name];
    if (row.name == "PIXEL_FILTER" && kinds::integrator(scene.integrator.name).from_lights) {
      cost.needed = "paths from lights never meet the pixels' middles alone";
      continue;
    }
    const std::optional<RenderSettings> less = without(row.name, variants[0], cost.needed);
    if (!less) continue;
    if (!has_shapes(features_of(scene, *less))) {
      cost.needed = "no shapes would be left";
      continue;
    }
    variants.push_back(*less);
    names.push_back(row.name);
  }
  VariantRounds with_sums = rounds;
  if (std::find(names.begin(), names.end(), "ERROR_SUMS") != names.end())
    with_sums.least_samples = std::max(rounds.least_samples, least_summed);
  costs.study = time_variants(device, scene, variants, with_sums, progress);
  for (std::size_t i = 1; i < names.size(); ++i)
    costs.effects[names[i]] = cost_of(names[i], costs.study, costs.study.variants[i]);
  return costs;
}

}  // namespace strahl
