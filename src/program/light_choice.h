// SPDX-License-Identifier: MIT
// By which entry of cl/choosers points choose among a scene's lights.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "scene/model/scene.h"

namespace strahl {

struct DrawnLights {
  std::size_t count = 0;
  std::size_t near = 0;  ///< Of these, not infinitely far away.
  /// Whether a sky shines into a medium without an end. What it brings depends on the chance of drawing it there, which
  /// is that of Mitsuba (docs/decisions/0030-media.md).
  bool weighs_sky = false;
};

/// Lights that are drawn from, as far as their kinds tell (one without an area counts too). is_used: whether the
/// program holds an effect, as FeatureReport names it.
[[nodiscard]] DrawnLights drawn_lights(const Scene& scene, const std::function<bool(const std::string&)>& is_used);

/// Throws UsageError for a name that is no chooser; none is the lights' own choice.
void require_chooser(const std::optional<std::string>& name);

/// "uniform" for a single light, "power" where all come from afar, "each" for few, else "tree"
/// (docs/decisions/0028-many-lights.md).
[[nodiscard]] std::string light_chooser(const DrawnLights& lights);

}  // namespace strahl
