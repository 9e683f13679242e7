// SPDX-License-Identifier: MIT
#include "oracle/oracle.h"
#include "selftest/proof_parts.h"

namespace strahl::selftest {
namespace {

/// Axes that span the plane of the normal exactly: their cross product is a multiple of it.
oracle::Disk disk_of(const double* planes) {
  const Vec3 n = at(planes + 3);
  const double x = std::fabs(n.x), y = std::fabs(n.y), z = std::fabs(n.z);
  oracle::Disk shape{at(planes), {n.y, -n.x, 0}, {n.z, 0, -n.x}, std::sqrt(planes[6])};
  if (y > x && y >= z) shape.axis_u = {0, n.z, -n.y}, shape.axis_v = {-n.y, n.x, 0};
  if (z > x && z > y) shape.axis_u = {-n.z, 0, n.x}, shape.axis_v = {0, -n.z, n.y};
  return shape;
}

class DiskProof : public ShapeProof {
 public:
  void draw(Question& q, oracle::Random& random, oracle::Law law) const override {
    const auto drawn = oracle::disk_case(random, law, oracle::Rounding::to_float);
    q.ray = drawn.ray;
    put(q, drawn.shape.center);
    put(q, cross(drawn.shape.axis_u, drawn.shape.axis_v));
    put(q, dot(drawn.shape.axis_u, drawn.shape.axis_u));
  }

  [[nodiscard]] ExactAnswer answer(const Asked& q) const override {
    if (q.has_left) return {};
    const auto met = oracle::disk(q.ray, disk_of(q.planes));
    const double cosine = std::fabs(dot(normalized(q.ray.direction), normalized(at(q.planes + 3))));
    const double away = length(q.ray.origin - at(q.planes));
    // The square root of the normal's length, because the normal may be a product of two radii.
    const double size = std::sqrt(q.planes[6]), unit = std::sqrt(length(at(q.planes + 3)));
    const bool is_seen = is_in_scale(size) && is_in_scale(unit) && away <= 0x1p40;
    return outside_band(met, is_seen && cosine >= 1e-7 && std::fabs(met.margin) > 4 * u);
  }

  [[nodiscard]] Promises promises() const override { return {0.5, 1, {}}; }

  [[nodiscard]] Vec3 normal(const double* planes, const Vec3&) const override { return at(planes + 3); }

  [[nodiscard]] Geometry geometry(const double* planes) const override {
    const double radius = std::sqrt(planes[6]);
    const auto [along_u, along_v] = orthonormal_basis(normalized(at(planes + 3)));
    return Disk{at(planes), radius * along_u, radius * along_v};
  }

  [[nodiscard]] std::vector<Generator> generators() const override { return disk_generators; }
};

}  // namespace

const ShapeProof& disk_proof() {
  static const DiskProof proof;
  return proof;
}

}  // namespace strahl::selftest
