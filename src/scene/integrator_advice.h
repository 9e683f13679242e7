// SPDX-License-Identifier: MIT
// What a scene's integrator misses, and which one finds it: by the scene alone, nothing is rendered.
#pragma once

#include <string>
#include <vector>

#include "scene/model/scene.h"

namespace strahl {

struct Advice {
  std::string integrator;  ///< That finds it.
  std::string why;         ///< What is missed, or found with much noise.
  SourceLocation where;    ///< Of what causes it.
};

/// Empty where the scene's integrator finds all light well. One that shows no light transport, as normals, is given
/// none.
[[nodiscard]] std::vector<Advice> integrator_advice(const Scene& scene);

/// What the scene's integrator finds with much noise or not at all, a phrase each: the advice's, and light that
/// integrators leave out by what they are. Empty where it finds all light well.
[[nodiscard]] std::vector<std::string> integrator_misses(const Scene& scene);

}  // namespace strahl
