// SPDX-License-Identifier: MIT
#include "render/shown_scene.h"

#include <utility>

#include "scene/empty_media.h"

namespace strahl {

Scene shown_scene(Scene scene, const RenderSettings& settings) {
  if (settings.aovs.empty()) leave_out_empty_media(scene);
  return scene;
}

}  // namespace strahl
