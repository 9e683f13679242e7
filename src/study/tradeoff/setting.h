// SPDX-License-Identifier: MIT
// One way to compute a scene: what a point of the study stands for.
#pragma once

#include <optional>
#include <string>

#include "scene/model/scene.h"
#include "settings/settings.h"

namespace strahl {

struct TradeoffSetting {
  Precision precision = Precision::robust;
  SamplerKind sampler = SamplerKind::sobol;
  std::optional<int> max_depth;  ///< -1: no limit; none: the integrator has none.
  int spp = 1;
  bool generic = false;

  friend bool operator==(const TradeoffSetting&, const TradeoffSetting&) = default;

  /// "robust-sobol-d8-64spp-specialised"; "dinf" without limit, no word where there is no depth. Names files.
  [[nodiscard]] std::string id() const;
  /// One row of the study; its programs differ in whether paths go in lanes at the most.
  [[nodiscard]] bool is_same_but_for_samples(const TradeoffSetting& other) const;
};

/// Whether the integrator's pictures depend on how far max_depth lets paths go.
[[nodiscard]] bool has_depth(const IntegratorSettings& integrator);

/// The scene as the setting computes it, apart from settings_of.
[[nodiscard]] Scene scene_of(Scene scene, const TradeoffSetting& setting);
[[nodiscard]] RenderSettings settings_of(const TradeoffSetting& setting);

}  // namespace strahl
