// SPDX-License-Identifier: MIT
#include "scene/empty_media.h"

#include <algorithm>

#include "kinds/integrators.h"
#include "scene/auto_integrator.h"
#include "scene/unseen.h"

namespace strahl {
namespace {

/// Emission is that of the share of light that a medium absorbs, so this glows no more than it absorbs.
bool is_empty(const Medium& medium) { return medium.sigma_t.largest() == Rgb{0, 0, 0}; }

}  // namespace

void leave_out_empty_media(Scene& scene) {
  if (!kinds::integrator(scene.integrator.name).goes_through) return;
  if (!std::all_of(scene.media.begin(), scene.media.end(), is_empty)) return;
  scene.media.clear();
  scene.camera.medium = -1;
  std::erase_if(scene.shapes, [&](const Shape& shape) { return is_unseen(shape, scene); });
  for (Shape& shape : scene.shapes) shape.media.reset();
  for (Group& group : scene.groups)
    for (Shape& shape : group.shapes) shape.media.reset();
  simplify_integrator(scene);
}

}  // namespace strahl
