// SPDX-License-Identifier: MIT
// What the tests against other programs' data share: where the data lies, and pictures by strahl.
#pragma once

#include <string>

#include "render/renderer.h"
#include "scene/loader.h"
#include "support/devices.h"

namespace strahl::test {

inline const std::string shared_data = STRAHL_SOURCE_DIR "/../shared/data/";

/// On PoCL, which may not be missing.
inline RenderResult picture(const Scene& scene, const RenderSettings& settings = {}) {
  require_pocl();
  return Renderer(Device::open("pocl"), scene, settings).render();
}

/// One ray through the middle of each pixel, and what it hits as layer shape_id (-1: nothing).
inline RenderResult hits(Scene scene, Precision precision = Precision::stable) {
  scene.integrator.name = "normals";
  scene.sampler.kind = SamplerKind::centre;
  scene.sampler.sample_count = 1;
  RenderSettings settings;
  settings.precision = precision;
  settings.aovs = {Aov::shape_id};
  return picture(scene, settings);
}

}  // namespace strahl::test
