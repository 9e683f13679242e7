// SPDX-License-Identifier: MIT
// Every scene by the program made for it, by the generic one, and without the film's sub-sums; and ten glowing spheres
// beside a kernel written for just that. What docs/effects.md shows.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/ten_spheres.h"
#include "study/variants.h"

namespace strahl::bench {

struct EffectsOptions {
  std::vector<std::string> scenes;  ///< Files; their names as they are to be shown.
  std::string folder;               ///< That they are in.
  bool only_spheres = false;
  int rounds = 7;
  double frame_seconds = 0.4;
};

struct SceneEffects {
  std::string scene;
  VariantStudy study;  ///< Specialised and generic, of a smaller picture with 16 samples.
  /// Specialised, ..., without sub-sums: `study` but where nothing is drawn. There 16 samples are one to a program that
  /// knows it, so `study` has the scene's own.
  std::optional<VariantStudy> of_16;
  int width = 0, height = 0, spp = 0;  ///< What the scene asks for.

  /// Seconds that kernels take for the scene's own picture.
  [[nodiscard]] double whole(const VariantTimes& times) const;
  /// Frames until building the specialised program has paid off where the generic one is there; infinite: never.
  [[nodiscard]] double break_even() const;
  /// What the sub-sums add to a frame, as a share.
  [[nodiscard]] double sums_cost() const { return 1 / without_sums().ratio() - 1; }
  [[nodiscard]] const VariantTimes& without_sums() const { return (of_16 ? *of_16 : study).variants.back(); }
};

struct Effects {
  std::string device;
  std::string version;
  int rounds = 0;
  VariantTimes generic;  ///< How long its program takes to build, and its size.
  std::vector<SceneEffects> scenes;
  std::vector<TenSpheres> spheres;
};

using EffectsProgress = std::function<void(const std::string& line)>;

[[nodiscard]] Effects measure_effects(const Device& device, const EffectsOptions& options,
                                      const EffectsProgress& progress);

[[nodiscard]] std::string json(const Effects& effects);
[[nodiscard]] std::string markdown(const Effects& effects);

}  // namespace strahl::bench
