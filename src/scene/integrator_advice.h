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

}  // namespace strahl
