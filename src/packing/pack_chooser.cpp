// SPDX-License-Identifier: MIT
#include "packing/pack_chooser.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "packing/choice_table.h"
#include "packing/cl_layout.h"
#include "packing/light_cluster.h"
#include "packing/light_tree.h"

namespace strahl {
namespace {

/// Around all bounded shapes and the places of the lights, in the frame's units; 1 where there are none.
double radius_of(const Scene& scene, const UploadFrame& frame, std::span<const LightReach> lights) {
  kinds::Extent extent;
  const auto add = [&](const std::optional<Box>& box) {
    if (box) extent.add(box->min), extent.add(box->max);
  };
  if (const std::optional<Box> box = bounds(scene)) add(Box{frame.point(box->min), frame.point(box->max)});
  for (const LightReach& light : lights) add(light.extent.box());
  const double radius = extent.box() ? 0.5 * length(extent.box()->max - extent.box()->min) : 0;
  return radius > 0 ? radius : 1;
}

/// Times a power of two, so that the largest lies in [1/2, 1). All finite and not negative.
void reduce(std::vector<double>& numbers) {
  const double largest = *std::max_element(numbers.begin(), numbers.end());
  const int exponent = largest > 0 ? std::ilogb(largest) + 1 : 0;
  for (double& number : numbers) number = std::scalbn(number, -exponent);
}

/// What of a far light's irradiance enters the scene is its power, times its weight. As in the tree, lights from afar
/// and near ones each have an eighth of the whole at least: the size of a scene says little of what a point in it sees.
std::vector<double> powers(const Scene& scene, const UploadFrame& frame, std::span<const LightReach> lights) {
  using Limits = std::numeric_limits<double>;
  const double radius = radius_of(scene, frame, lights), disc = std::numbers::pi * radius * radius;
  std::vector<double> all, weights;
  for (const LightReach& light : lights) {
    const double power = light.power * (light.is_far ? disc : 1);
    all.push_back(power > 0 ? std::min(power, Limits::max()) : 0);
    weights.push_back(light.weight);
  }
  reduce(all);
  reduce(weights);
  double far = 0, near = 0;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    // Nothing that may be drawn is lost by being small.
    if (lights[i].power > 0) all[i] = std::max(weights[i] * all[i], Limits::min());
    (lights[i].is_far ? far : near) += all[i];
  }
  if (!(far + near > 0)) return std::vector<double>(lights.size(), 1);
  if (!(far > 0) || !(near > 0)) return all;
  const double share = std::clamp(far / (far + near), 0.125, 0.875);
  for (std::size_t i = 0; i < lights.size(); ++i) all[i] *= lights[i].is_far ? share / far : (1 - share) / near;
  return all;
}

}  // namespace

template <typename Real>
void pack_chooser(PackedScene<Real>& packed, const Scene& scene, const Features& features, const UploadFrame& frame,
                  std::span<const LightReach> lights) {
  packed.at(layout::HEADER_CHOOSER) = features.entry_index("choosers", features.light_chooser);
  if (lights.size() < 2) return;
  if (features.light_chooser == "power") {
    const std::vector<double> all = powers(scene, frame, lights);
    const std::vector<Choice> table = choice_table(all);
    std::vector<double> rarities = choice_rarities(table, all);
    for (double& rarity : rarities) rarity = std::min(rarity, static_cast<double>(std::numeric_limits<Real>::max()));
    const int rarities_at = packed.put_shading(rarities);
    const int choices_at = put_choices(packed, table);
    packed.at(layout::HEADER_CHANCES) = rarities_at;
    packed.at(layout::HEADER_CHOICES) = choices_at;
  }
  if (features.light_chooser == "each") {
    std::vector<double> children;
    const double least_radius = least_light_radius(lights);
    for (const LightReach& light : lights) {
      const std::vector<double> child = LightCluster::of(light).reals(least_radius);
      children.insert(children.end(), child.begin(), child.end());
    }
    const int children_at = packed.put_shading(children);
    packed.at(layout::HEADER_CHANCES) = children_at;
  }
  if (features.light_chooser == "tree") {
    const LightTree tree = light_tree(lights);
    const int children_at = packed.put_shading(tree.children);
    const int ways_at = packed.put_index(tree.ways);
    packed.put_index(tree.links);
    packed.at(layout::HEADER_CHANCES) = children_at;
    packed.at(layout::HEADER_CHOICES) = ways_at;
  }
}

template void pack_chooser(PackedScene<float>&, const Scene&, const Features&, const UploadFrame&,
                           std::span<const LightReach>);
template void pack_chooser(PackedScene<double>&, const Scene&, const Features&, const UploadFrame&,
                           std::span<const LightReach>);

}  // namespace strahl
