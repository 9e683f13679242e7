// SPDX-License-Identifier: MIT
#include "render/traversal_choice.h"

#include "packing/pack_tree.h"

namespace strahl {

TraversalChoice choose_traversal(const Scene& scene, const Features& features, const RenderSettings& settings,
                                 Width width) {
  const bool has_tree = calls_for_tree(scene, features, width.tree, settings.acceleration);
  return {has_tree, has_tree ? settings.acceleration : Acceleration::list};
}

}  // namespace strahl
