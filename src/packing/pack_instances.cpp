// SPDX-License-Identifier: MIT
#include "packing/pack_instances.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "errors.h"
#include "kinds/extent.h"
#include "scene/model/transforms.h"

namespace strahl {
namespace {

/// The multiple of a power of two not below twice `half` that is nearest to x: few digits, and 0 where 0 is near.
double few_digits(double x, double half) {
  if (!(half > 0) || !std::isfinite(half) || !std::isfinite(x)) return 0;
  const double step = std::ldexp(1.0, std::ilogb(half) + 2);
  return step * std::nearbyint(x / step);
}

Vec3 pivot_of(const Vec3& lo, const Vec3& hi) {
  const Vec3 center = 0.5 * (lo + hi);
  const double half = 0.5 * largest_component(hi - lo);
  return {few_digits(center.x, half), few_digits(center.y, half), few_digits(center.z, half)};
}

Vec3 absolute(const Vec3& v) { return {std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}; }

/// The linear part with the magnitudes of its numbers.
Transform magnitudes(Transform transform) {
  for (auto& row : transform.m) {
    for (double& x : row) x = std::fabs(x);
    row[3] = 0;
  }
  return transform;
}

template <typename Real>
Vec3 rounded(const Vec3& v) {
  const auto round = [](double x) { return static_cast<double>(static_cast<Real>(x)); };
  return {round(v.x), round(v.y), round(v.z)};
}

template <typename Real>
void put(InstanceReals<Real>& reals, int at, const Vec3& v) {
  for (const double x : {v.x, v.y, v.z}) reals[static_cast<std::size_t>(at++)] = static_cast<Real>(x);
}

template <typename Real>
void put_linear(InstanceReals<Real>& reals, int at, const Transform& transform) {
  for (int row = 0; row < 3; ++row) {
    const auto& m = transform.m[static_cast<std::size_t>(row)];
    put(reals, at + 3 * row, {m[0], m[1], m[2]});
  }
}

/// Around boxes of the group where the instance has them: p = pivot + A (x - offset).
template <typename Real>
Box mapped(std::span<const Bounds<Real>> boxes, const Transform& a, const Vec3& offset, const Vec3& pivot) {
  const Transform magnitude = magnitudes(a);
  kinds::Extent all;
  for (const Bounds<Real>& box : boxes) {
    const Vec3 lo{double(box[0]), double(box[2]), double(box[4])}, hi{double(box[1]), double(box[3]), double(box[5])};
    all.add(pivot + a.vector(0.5 * (lo + hi) - offset), magnitude.vector(0.5 * (hi - lo)));
  }
  return *all.box();
}

/// Rounded first: what the kernels compute with is the instance, and all else follows from it.
template <typename Real>
Transform rounded_inverse(const Transform& map) {
  Transform inverse = map.inverse();
  for (auto& row : inverse.m) {
    for (std::size_t i = 0; i < 3; ++i) row[i] = static_cast<double>(static_cast<Real>(row[i]));
    row[3] = 0;
  }
  return inverse;
}

/// To a hundredth.
bool is_identity(const Transform& map) {
  for (int i = 0; i < 3; ++i)
    if (!(length(map.column(i) - Transform{}.column(i)) < 0.01)) return false;  // NaN is not.
  return true;
}

/// What is placed is the inverse of the rounded inverse. With M the map and E the rounding of its inverse that is
/// M (1 + E M)^-1 = (1 + M E)^-1 M: M, where either product is small.
template <typename Real>
void require_held(const Transform& map, const Transform& inverse, const SourceLocation& where) {
  if (is_identity(inverse * map) || is_identity(map * inverse)) return;
  throw SceneError({{Severity::error, where,
                     fmt::format("the instance's transform flattens or scales so much that {} bits do not hold it{}",
                                 8 * sizeof(Real), sizeof(Real) < sizeof(double) ? "; --precision double may" : "")}});
}

}  // namespace

UploadFrame group_frame(const Group& group, const UploadFrame& scene) {
  const std::optional<Box> box = bounds(group);
  if (!scene.is_chosen || !box) return {};
  UploadFrame frame{pivot_of(box->min, box->max), 1, true};
  const double extent =
      std::max(largest_component(box->min - frame.origin), largest_component(box->max - frame.origin));
  if (extent > 0 && std::isfinite(extent)) frame.scale = std::ldexp(1.0, -std::ilogb(extent));
  return frame;
}

Transform frame_from_group(const Instance& instance, const UploadFrame& group, const UploadFrame& scene) {
  Transform map = instance.world_from_group;
  const Vec3 origin = scene.point(map.point(group.origin));
  for (auto& row : map.m)
    for (std::size_t i = 0; i < 3; ++i) row[i] *= scene.scale / group.scale;
  map.m[0][3] = origin.x;
  map.m[1][3] = origin.y;
  map.m[2][3] = origin.z;
  return map;
}

template <typename Real>
InstanceReals<Real> instance_reals(const Transform& frame_from_group, const Bounds<Real>& box,
                                   const std::vector<Bounds<Real>>& outline, const SourceLocation& where) {
  const Vec3 lo{double(box[0]), double(box[2]), double(box[4])}, hi{double(box[1]), double(box[3]), double(box[5])};
  const Vec3 pivot_in_group = pivot_of(lo, hi), pivot_exact = frame_from_group.point(pivot_in_group);
  const Vec3 pivot = rounded<Real>(pivot_exact);
  const Transform to_group = rounded_inverse<Real>(frame_from_group);
  require_held<Real>(frame_from_group, to_group, where);
  const Vec3 offset = rounded<Real>(pivot_in_group + to_group.vector(pivot - pivot_exact));
  const Transform to_frame = to_group.inverse();

  const auto [least, most] = mapped<Real>({&box, 1}, to_frame, offset, pivot);
  // What is rounded when a point of the instance is mapped: within the group, and before that on the way there.
  const Vec3 in_group =
      absolute(offset) + Vec3{std::max(std::fabs(lo.x), std::fabs(hi.x)), std::max(std::fabs(lo.y), std::fabs(hi.y)),
                              std::max(std::fabs(lo.z), std::fabs(hi.z))};
  const Vec3 around = 0.5 * (most - least) + absolute(0.5 * (most + least) - pivot);
  const Transform there = magnitudes(to_group), back = magnitudes(to_frame);
  const double error = 2 * largest_component(back.vector(in_group + there.vector(around)));

  InstanceReals<Real> reals;
  // Outwards by more than the corners and the mapping of rays that begin nearby round.
  const double out = 4 * std::numeric_limits<Real>::epsilon() * (error + largest_component(absolute(pivot) + around));
  const Box tight = outline.empty() ? Box{least, most} : mapped<Real>(outline, to_frame, offset, pivot);
  const Bounds<Real> outer = rounded_outwards<Real>(tight.min - Vec3{out, out, out}, tight.max + Vec3{out, out, out});
  std::copy(outer.begin(), outer.end(), reals.begin() + layout::INSTANCE_BOX);
  put(reals, layout::INSTANCE_PIVOT, pivot);
  put_linear(reals, layout::INSTANCE_TO_GROUP, to_group);
  put(reals, layout::INSTANCE_OFFSET, offset);
  put_linear(reals, layout::INSTANCE_TO_WORLD, to_frame);
  reals[layout::INSTANCE_ERROR] = static_cast<Real>(error);
  reals[layout::INSTANCE_SHRINK] = static_cast<Real>(1 / largest_stretch(to_frame));
  return reals;
}

template InstanceReals<float> instance_reals(const Transform&, const Bounds<float>&, const std::vector<Bounds<float>>&,
                                             const SourceLocation&);
template InstanceReals<double> instance_reals(const Transform&, const Bounds<double>&,
                                              const std::vector<Bounds<double>>&, const SourceLocation&);

}  // namespace strahl
