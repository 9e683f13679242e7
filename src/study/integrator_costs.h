// SPDX-License-Identifier: MIT
// What each integrator would miss of a scene, and how long it would take to a given error: measured by a pilot of each
// at a low resolution (render/pilot.h).
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "opencl/device.h"
#include "render/prediction.h"
#include "scene/model/scene.h"
#include "settings/settings.h"
#include "study/variants.h"

namespace strahl {

struct IntegratorCost {
  std::string integrator;
  std::string refused;                  ///< Why it renders no such scene; empty: it does. Then all else is measured.
  std::vector<std::string> misses;      ///< Kinds of light that it does not find, or finds with much noise.
  std::optional<double> build_seconds;  ///< Of its program; none where it was kept.
  double sample_seconds = 0;            ///< Of one sample of every pixel of the scene's picture, building aside.
  double mean = 0;                      ///< Of the pilot's picture.
  std::optional<Range> seconds, spp;    ///< To the error, but to no more samples than the film holds; none where the
                                        ///< pilot saw no noise, or samples that are not finite.
  bool is_beyond_film = false;          ///< The film ends it before the error is reached, by the middle of `spp`.
  bool has_finite_samples = true;       ///< Of the pilot: else its error is not known, nor when it would end.
};

struct IntegratorCosts {
  int width = 0, height = 0;  ///< Of the pilots' pictures.
  double pilot_seconds = 0;   ///< That each may take.
  double share = 0;           ///< The error is this share of the mean ...
  double rmse = 0;            ///< ... of the picture of the scene's own integrator, asked for or not; of the brightest
                              ///< where that is black, refused or no light transport; 0: all of them are black.
  std::vector<IntegratorCost> integrators;
};

/// In the order of cl/integrators/integrators.def.
[[nodiscard]] std::vector<std::string> light_transport_names();

/// Of every integrator of light transport, in their order, or of those named: these must be light transport. The
/// errors of pixels do not depend on the resolution, but for details that are lost at the pilots' at most 128 pixels.
/// What is rare may not be seen at all in a pilot; `misses` tells of it.
[[nodiscard]] IntegratorCosts measure_integrators(const Device& device, const Scene& scene,
                                                  const RenderSettings& settings, double pilot_seconds = 2,
                                                  double share = 0.01, const StudyProgress& progress = {},
                                                  const std::set<std::string>& names = {});

}  // namespace strahl
