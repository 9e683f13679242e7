// SPDX-License-Identifier: MIT
// A loop counts one turn more than it makes: llvmpipe counts the turn that finds its end. Paths of neighbouring
// work-items run in step there, so that every loop counts its longest, reached by this pixel's own path or not.
#include "render/loop_bound.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "device/cl_layout.h"
#include "device/features.h"
#include "device/kernel_source.h"
#include "device/pack.h"
#include "errors.h"

namespace strahl {
namespace {

/// Loops over the axes and faces of a box, in one test and where its surface is looked up.
constexpr double box_test = 24, box_surface = 16;
/// Of the traversal's loop, in an instance that lists nothing.
constexpr double enter_and_leave = 4;
/// Over a polygon's edges, twice, where a ray leaves it (cl/core/departure.h).
constexpr double departure = 3 + 2 * 5;

/// One node of a tree: its children one after the other, and each that is met past all that wait from the same node.
double node_test(int lanes) {
  const double children = lanes == 1 ? 4 : lanes;
  return 2 + (lanes == 1 ? children + 1 : 2) + children * (1 + children / 2);
}

/// Everything that lists or a tree hold together, met.
double meet(const std::vector<Shape>& shapes, double instances, int lanes, Acceleration acceleration) {
  std::map<std::string, double> primitives;
  for (const Shape& shape : shapes) primitives[shape_kind(shape)] += primitive_count(shape);
  double turns = enter_and_leave * instances;
  for (const auto& [kind, count] : primitives) {
    const double candidates = lanes + 1;
    turns += std::ceil(count / lanes) * (1 + candidates + (kind == "box" ? box_test : 0));
    if (acceleration != Acceleration::list && kind != "plane") turns += count / lanes * node_test(lanes);
  }
  if (acceleration != Acceleration::list) turns += instances * node_test(lanes);
  return turns;
}

/// One traversal that meets everything, by lists or in trees whose nodes have two children each.
double walk(const Scene& scene, int lanes, Acceleration acceleration) {
  const auto kinds = static_cast<double>(list_entries("shapes").size());
  std::vector<double> within;
  for (const Group& group : scene.groups) within.push_back(2 * kinds + 2 + meet(group.shapes, 0, lanes, acceleration));
  double turns = kinds + meet(scene.shapes, static_cast<double>(scene.instances.size()), lanes, acceleration);
  for (const Instance& instance : scene.instances) turns += within.at(static_cast<std::size_t>(instance.group));
  return turns;
}

bool is_lamp(const Light& light) { return !std::holds_alternative<ConstantLight>(light.emitter); }

double emitting_primitives(const Scene& scene) {
  double count = 0;
  for (const Shape& shape : scene.shapes) {
    const auto* mesh = std::get_if<Mesh>(&shape.geometry);
    const bool in_part = mesh && std::any_of(mesh->parts.begin(), mesh->parts.end(),
                                             [](const MeshPart& part) { return part.radiance.has_value(); });
    if (shape.radiance || in_part) count += primitive_count(shape);
  }
  return count;
}

bool has_mirrors(const Scene& scene) {
  return std::any_of(scene.materials.begin(), scene.materials.end(),
                     [](const Material& material) { return std::holds_alternative<Conductor>(material.bsdf); });
}

/// Surfaces that a path can come to, after hidden emitters.
double surfaces(const Scene& scene, bool has_glow) {
  const std::string& integrator = scene.integrator.name;
  if (integrator == "path") return std::max(most_surfaces(scene.integrator), 1);
  if (integrator == "direct") return has_glow ? 2 : 1;
  if (integrator != "whitted" || !has_mirrors(scene)) return 1;
  const int depth = scene.integrator.max_depth;
  return 1 + (depth < 0 ? layout::WHITTED_LONGEST : std::max(depth - 1, 0));
}

/// Shadow rays at a surface.
double shadows(const Scene& scene, bool has_glow) {
  const std::string& integrator = scene.integrator.name;
  if (integrator == "path" || integrator == "ao") return 1;
  if (integrator != "direct" && integrator != "whitted") return 0;
  const auto lamps = std::count_if(scene.lights.begin(), scene.lights.end(), is_lamp);
  return static_cast<double>(lamps) + (has_glow ? 1 : 0);
}

}  // namespace

LoopBound render_loops(const Scene& scene, int lanes, Acceleration acceleration) {
  const double emitters = emitting_primitives(scene);
  const bool has_glow = emitters > 0 || !std::all_of(scene.lights.begin(), scene.lights.end(), is_lamp);
  const double ray = walk(scene, lanes, acceleration);
  // The loops over the path and the lights, each with its shadow.
  const double surface = 1 + ray + box_surface + 1 + shadows(scene, has_glow) * (1 + departure + ray) + departure;
  const double hidden = scene.integrator.hide_emitters ? 2 * emitters : 0;
  return {2 * layout::FILM_SUBSUMS + 1, 1 + layout::AOV_REALS + 1 + (hidden + surfaces(scene, has_glow)) * surface};
}

LoopBound intersect_loops(const Scene& scene, int lanes, Acceleration acceleration) {
  return {layout::HIT_REALS + 1, walk(scene, lanes, acceleration) + box_surface};
}

double samples_within(std::uint64_t loop_turns, const LoopBound& bound) {
  return std::floor((static_cast<double>(loop_turns) - bound.launch) / bound.sample);
}

int most_samples(const Device& device, const LoopBound& bound, std::optional<std::uint64_t> loop_turns) {
  constexpr int all = std::numeric_limits<int>::max();
  if (!loop_turns) return all;
  const double samples = samples_within(*loop_turns, bound);
  if (samples >= 1) return samples < all ? static_cast<int>(samples) : all;
  throw NoDeviceError(fmt::format(
      "{} ends the loops of a work-item after {} turns, and the hit or picture would be wrong: a ray of this "
      "scene may take {:.0f}, with all its mirrors and shadows; choose another device (-d), a smaller "
      "max_depth (--max-depth) or fewer shapes",
      device.info().text(), *loop_turns, bound.launch + bound.sample));
}

}  // namespace strahl
