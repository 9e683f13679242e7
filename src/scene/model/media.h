// SPDX-License-Identifier: MIT
// What lies between surfaces.
#pragma once

#include <string>
#include <vector>

#include "errors.h"
#include "scene/model/vec.h"
#include "scene/model/volume.h"

namespace strahl {

/// How a medium turns light, by the angle alone (cl/phases).
struct PhaseFunction {
  enum class Kind { isotropic, hg, rayleigh };
  Kind kind = Kind::isotropic;
  double share = 1;  ///< Of several: those of a medium add up to 1.
  double g = 0;      ///< Of hg: the mean cosine, within (-1, 1).
};

/// Alike everywhere, or, where sigma_t is a grid, within the axis-aligned box around that.
struct Medium {
  std::string id;
  Volume sigma_t = Rgb{1, 1, 1};          ///< What is absorbed or scattered, per unit of length; at least 0.
  Volume albedo = Rgb{0.75, 0.75, 0.75};  ///< The share of that which is scattered, within [0, 1].
  Volume emission = Rgb{0, 0, 0};         ///< Radiance of an infinite depth of it where nothing is scattered.
  std::vector<PhaseFunction> phases{PhaseFunction{}};
  bool samples_emitters = true;  ///< Lights are drawn where paths scatter, not only found.
  SourceLocation where;

  [[nodiscard]] bool is_heterogeneous() const { return sigma_t.grid != nullptr; }
};

/// A surface between two media: indices into Scene::media; -1: none there.
struct MediumBoundary {
  int inside = -1;   ///< Behind the surface.
  int outside = -1;  ///< Where its normal points to.
};

}  // namespace strahl
