// SPDX-License-Identifier: MIT
#include "packing/path_lengths.h"

#include <algorithm>
#include <limits>
#include <span>

#include "kinds/extent.h"
#include "kinds/integrators.h"
#include "packing/cl_layout.h"
#include "packing/shape_parts.h"

namespace strahl {
namespace {

constexpr int never = std::numeric_limits<int>::max();

/// More of them hardly miss more rays, and each ray is tested against all.
constexpr std::size_t most_boxes = 8;

/// Of the largest coordinate, by which boxes are larger: far more than any tier rounds where it finds a hit.
constexpr double slack = 0x1p-10;

/// Surfaces before a ray behind which nothing is lit or scatters.
int last_depth(const IntegratorSettings& integrator) {
  const kinds::IntegratorFacts& facts = kinds::integrator(integrator.name);
  if (facts.goes_through || facts.from_lights) return never;
  if (facts.follows == kinds::Follows::one_way) return 1;
  return facts.follows == kinds::Follows::paths ? most_surfaces(integrator) - 1 : never;
}

bool is_glowing(const Shape& shape) {
  for (int part = 0; part < part_count(shape); ++part)
    if (look_of_part(shape, part).radiance) return true;
  return false;
}

/// Those that stand next to each other along the longest axis of all are one, until they are few.
std::vector<Box> few_of(std::vector<Box> boxes) {
  if (boxes.size() <= most_boxes) return boxes;
  const auto around = [](std::span<const Box> some) {
    kinds::Extent all;
    for (const Box& box : some) {
      all.add(box.min);
      all.add(box.max);
    }
    return *all.box();
  };
  const Box all = around(boxes);
  const Vec3 size = all.max - all.min;
  const double Vec3::*axis = size.x >= size.y && size.x >= size.z ? &Vec3::x : size.y >= size.z ? &Vec3::y : &Vec3::z;
  std::stable_sort(boxes.begin(), boxes.end(),
                   [&](const Box& a, const Box& b) { return a.min.*axis + a.max.*axis < b.min.*axis + b.max.*axis; });
  std::vector<Box> few;
  for (std::size_t i = 0; i < most_boxes; ++i) {
    const std::size_t from = boxes.size() * i / most_boxes, to = boxes.size() * (i + 1) / most_boxes;
    few.push_back(around(std::span(boxes).subspan(from, to - from)));
  }
  return few;
}

}  // namespace

int most_surfaces(const IntegratorSettings& integrator) {
  if (integrator.max_depth >= 0 || kinds::integrator(integrator.name).follows != kinds::Follows::paths)
    return integrator.max_depth;
  return std::min(integrator.rr_depth, never - layout::ROULETTE_LONGEST) + layout::ROULETTE_LONGEST;
}

template <typename Real>
void pack_last_rays(PackedScene<Real>& packed, const Scene& scene, const UploadFrame& frame) {
  packed.at(layout::HEADER_LAST_DEPTH) = never;
  const int last = last_depth(scene.integrator);
  if (last == never || packed.at(layout::HEADER_BACKGROUND) >= 0 || packed.at(layout::HEADER_SUN) >= 0) return;
  std::vector<Box> boxes;
  for (const Shape& shape : scene.shapes) {
    if (!is_glowing(shape)) continue;
    const std::optional<Box> box = bounds(shape);
    if (!box) return;
    boxes.push_back({frame.point(box->min), frame.point(box->max)});
  }
  packed.at(layout::HEADER_LAST_DEPTH) = last;
  std::vector<double> reals;
  for (const Box& box : few_of(std::move(boxes))) {
    const double by = slack * std::max(largest_component(box.min), largest_component(box.max));
    const Vec3 lo = box.min - Vec3{by, by, by}, hi = box.max + Vec3{by, by, by};
    reals.insert(reals.end(), {lo.x, lo.y, lo.z, hi.x, hi.y, hi.z});
  }
  packed.at(layout::HEADER_GLOWING_COUNT) = static_cast<int>(reals.size() / 6);
  const int at = packed.put_shading(reals);
  packed.at(layout::HEADER_GLOWING) = at;
}

template void pack_last_rays(PackedScene<float>&, const Scene&, const UploadFrame&);
template void pack_last_rays(PackedScene<double>&, const Scene&, const UploadFrame&);

}  // namespace strahl
