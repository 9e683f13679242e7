// SPDX-License-Identifier: MIT
#include "render/traversal_choice.h"

#include "device/pack_tree.h"

namespace strahl {

TraversalChoice choose_traversal(const Scene& scene, const Features& features, const RenderSettings& settings,
                                 Width width, LoopBound (*loops)(const Scene&, int lanes, Acceleration)) {
  const auto chosen = [&](Acceleration wanted) {
    const bool has_tree = calls_for_tree(scene, features, width.tree, wanted);
    const Acceleration acceleration = has_tree ? wanted : Acceleration::list;
    return TraversalChoice{has_tree, acceleration, loops(scene, width.lanes, acceleration)};
  };
  const TraversalChoice choice = chosen(settings.acceleration);
  const bool is_open = settings.acceleration == Acceleration::automatic && settings.loop_turns;
  return is_open && samples_within(*settings.loop_turns, choice.loops) < 1 ? chosen(Acceleration::list) : choice;
}

}  // namespace strahl
