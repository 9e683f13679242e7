// SPDX-License-Identifier: MIT
#include "study/tradeoff/setting.h"

#include <fmt/format.h>

#include "kinds/integrators.h"
#include "settings/sampler_name.h"

namespace strahl {
namespace {

std::string depth_word(const std::optional<int>& max_depth) {
  if (!max_depth) return "";
  return *max_depth < 0 ? "dinf-" : fmt::format("d{}-", *max_depth);
}

}  // namespace

std::string TradeoffSetting::id() const {
  return fmt::format("{}-{}-{}{}spp-{}", precision_name(precision), sampler_name(sampler), depth_word(max_depth), spp,
                     generic ? "generic" : "specialised");
}

bool TradeoffSetting::is_same_but_for_samples(const TradeoffSetting& other) const {
  TradeoffSetting as_many = *this;
  as_many.spp = other.spp;
  return as_many == other;
}

bool has_depth(const IntegratorSettings& integrator) { return kinds::integrator(integrator.name).has_depth(); }

Scene scene_of(Scene scene, const TradeoffSetting& setting) {
  scene.sampler.kind = setting.sampler;
  scene.sampler.sample_count = setting.spp;
  if (setting.max_depth) scene.integrator.max_depth = *setting.max_depth;
  return scene;
}

RenderSettings settings_of(const TradeoffSetting& setting) {
  RenderSettings settings;
  settings.precision = setting.precision;
  settings.generic = setting.generic;
  return settings;
}

}  // namespace strahl
