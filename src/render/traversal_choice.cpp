// SPDX-License-Identifier: MIT
#include "render/traversal_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>

#include "errors.h"
#include "kinds/entries.h"
#include "packing/pack_tree.h"
#include "packing/primitive_bounds.h"

namespace strahl {
namespace {

/// Beyond it a tree is faster than a list for rays in lanes (docs/decisions/0026-path-pool.md).
constexpr double most_list_cost = 24;

/// What a packet pays for all primitives that a tree could hold; the unit is the test of a polygon.
double list_cost(const Scene& scene, const Features& features) {
  double cost = 0;
  for (const Shape& shape : scene.shapes) {
    const std::string kind = shape_kind(shape);
    if (!features.has("shapes", kind) || bounds_function<float>(kind) == nullptr) continue;
    cost += (kind == "sphere" ? 0.25 : 1.0) * primitive_count(shape);
    if (cost > most_list_cost) break;
  }
  return cost;
}

}  // namespace

Width wide_enough(Width width, std::int64_t primitives, const RenderSettings& settings) {
  if (width.tree >= 8 || primitives <= most_blocks || settings.acceleration == Acceleration::list) return width;
  if (!settings.lanes && !settings.bvh_width) return {8, 8};
  throw UsageError(
      fmt::format("{} {}: such a tree names at most {} primitives of a kind, and the scene has {}; state "
                  "--bvh-width 8{}",
                  settings.bvh_width ? "--bvh-width" : "--lanes", settings.bvh_width.value_or(width.lanes), most_blocks,
                  primitives, settings.bvh_width ? "" : " in its place"));
}

Width wide_enough(Width width, const Scene& scene, const RenderSettings& settings) {
  if (width.tree >= 8) return width;
  std::map<std::string, std::int64_t> primitives;
  std::int64_t most = 0;
  for_each_shape(scene, [&](const Shape& shape) {
    std::int64_t& of_kind = primitives[shape_kind(shape)];
    of_kind += primitive_count(shape);
    most = std::max(most, of_kind);
  });
  return wide_enough(width, most, settings);
}

TraversalChoice choose_traversal(const Scene& scene, const Features& features, const RenderSettings& settings,
                                 Width width, int path_lanes) {
  Acceleration acceleration = settings.acceleration;
  if (acceleration == Acceleration::automatic && path_lanes > 1 && !features.flag("INSTANCES"))
    acceleration = list_cost(scene, features) > most_list_cost ? Acceleration::tree : Acceleration::list;
  const bool has_tree = calls_for_tree(scene, features, width.tree, acceleration);
  return {has_tree, has_tree ? acceleration : Acceleration::list};
}

}  // namespace strahl
