// SPDX-License-Identifier: MIT
#include "packing/light_cluster.h"

#include <algorithm>
#include <cmath>

#include "packing/cl_layout.h"

namespace strahl {
namespace {

using std::numbers::pi;

/// Cones are wider by this, in radians, than lights are: cosines near 1 tell angles in single precision to 3e-4, and no
/// light that reaches a point may have no chance there.
constexpr double slack = 0.004;

/// Lights that may be drawn are no weaker, so that single precision keeps what they bring: those from afar are drawn,
/// however weak, for an eighth of all.
constexpr double least_strength = 0x1p-100;

double strength_of(const LightReach& light) {
  return light.weight > 0 && light.intensity > 0 ? std::max(light.weight * light.intensity, least_strength) : 0;
}

double angle_between(const Vec3& a, const Vec3& b) {
  // W. Kahan, "How Futile are Mindless Assessments of Roundoff in Floating-Point Computation?", 2006, section 12.
  return 2 * std::atan2(length(a - b), length(a + b));
}

}  // namespace

LightCluster LightCluster::of(const LightReach& light) {
  LightCluster cluster;
  cluster.strength = strength_of(light);
  cluster.is_far = light.is_far;
  cluster.box = light.extent.box();
  cluster.axis = light.axis;
  cluster.spread = light.spread;
  cluster.cutoff = light.cutoff;
  return cluster;
}

void LightCluster::include(const LightCluster& other) {
  const Vec3 sum = strength * axis + other.strength * other.axis;
  const Vec3 middle = length(sum) > 0 ? normalized(sum) : axis;
  spread =
      std::min(pi, std::max(angle_between(middle, axis) + spread, angle_between(middle, other.axis) + other.spread));
  axis = middle;
  cutoff = std::max(cutoff, other.cutoff);
  strength += other.strength;
  if (!box) box = other.box;
  if (!other.box) return;
  kinds::Extent extent;
  for (const Vec3& corner : {box->min, box->max, other.box->min, other.box->max}) extent.add(corner);
  box = extent.box();
}

double LightCluster::cost() const {
  const Vec3 d = box ? box->max - box->min : Vec3{};
  const double surface = d.x * d.y + d.y * d.z + d.z * d.x, edges = d.x + d.y + d.z;
  const double wide = std::min(spread + cutoff, pi), low = std::min(spread, pi);
  // The solid angle of the spread, and what shines beyond it with a falling cosine.
  const double angles =
      2 * pi * (1 - std::cos(low)) +
      0.5 * pi * (2 * wide * std::sin(low) - std::cos(low - 2 * wide) - 2 * low * std::sin(low) + std::cos(low));
  return strength * (surface + 1e-3 * edges * edges) * angles;
}

std::vector<double> LightCluster::reals(double least_radius) const {
  if (is_far || !box) return {0, 0, 0, axis.x, axis.y, axis.z, strength, -1, -1, -1};
  const Vec3 middle = 0.5 * (box->min + box->max);
  const double radius = std::max(0.5 * length(box->max - box->min), least_radius);
  const auto cosine = [](double angle) { return std::cos(std::min(angle + slack, pi)); };
  return {middle.x, middle.y, middle.z,        axis.x,         axis.y,
          axis.z,   strength, radius * radius, cosine(spread), cosine(cutoff)};
}

double least_light_radius(std::span<const LightReach> lights) {
  kinds::Extent extent;
  for (const LightReach& light : lights)
    if (const std::optional<Box> box = light.extent.box()) extent.add(box->min), extent.add(box->max);
  const double size = extent.box() ? length(extent.box()->max - extent.box()->min) : 0;
  return size > 0 ? 1e-6 * size : 1e-6;
}

}  // namespace strahl
