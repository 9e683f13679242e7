// SPDX-License-Identifier: MIT
#include "packing/pack_areas.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "packing/pack_shapes.h"

namespace strahl {

int first_of_area(const Geometry& geometry, int part, bool shines_inwards) {
  return std::visit([=](const auto& shape) { return kinds::first_of_area(shape, part, shines_inwards); }, geometry);
}

namespace {

/// The cone of the items' normals, if all of them are flat. Of items that face all ways the mean area that is seen is a
/// quarter of the whole, as A. Cauchy found of convex bodies.
LightReach reach_of(kinds::AreaItems& items, double size, const Rgb& radiance, const UploadFrame& frame) {
  LightReach reach;
  if (const std::optional<Box>& box = items.extent().box()) {
    reach.extent.add(frame.point(box->min));
    reach.extent.add(frame.point(box->max));
  }
  reach.power = std::numbers::pi * size * luminance(radiance);
  reach.cutoff = std::numbers::pi / 2;
  Vec3 sum;
  for (std::size_t i = 0; i < items.normals().size(); ++i) sum = sum + items.weights()[i] * items.normals()[i];
  const bool is_flat = items.normals().size() == items.weights().size() && length(sum) > 0;
  if (is_flat) {
    reach.axis = normalized(sum);
    double least = 1;
    for (const Vec3& normal : items.normals()) least = std::min(least, dot(reach.axis, normal));
    reach.spread = std::isfinite(least) ? std::acos(std::max(least, -1.0)) : std::numbers::pi;
  }
  reach.intensity = size * luminance(radiance) * (reach.spread < std::numbers::pi / 2 ? 1 : 0.25);
  return reach;
}

}  // namespace

std::optional<EmittingArea> emitting_area(const Shape& shape, kinds::Primitives primitives, const Rgb& radiance,
                                          kinds::UvSource uv_source, const UploadFrame& frame) {
  kinds::AreaItems items(frame, shape.flip_normals != faces_inward(shape.geometry), uv_source);
  std::visit([&](const auto& geometry) { kinds::emit(items, geometry, primitives); }, shape.geometry);
  std::vector<double>& weights = items.weights();
  for (double& weight : weights)
    if (!std::isfinite(weight)) weight = 0;
  EmittingArea area;
  area.size = std::accumulate(weights.begin(), weights.end(), 0.0);
  if (!(area.size > 0 && std::isfinite(area.size))) return std::nullopt;
  area.side = items.is_flipped() ? -1 : 1;
  area.reach = reach_of(items, area.size, radiance, frame);
  area.reach.weight = shape.sampling_weight;
  area.items = std::move(items.items());
  area.uvs = std::move(items.uvs());
  area.choices = choice_table(weights);
  return area;
}

}  // namespace strahl
