// SPDX-License-Identifier: MIT
#include "oracle/oracle.h"
#include "selftest/proof_parts.h"

namespace strahl::selftest {
namespace {

class PlaneProof : public ShapeProof {
 public:
  void draw(Question& q, oracle::Random& random, oracle::Law law) const override {
    const auto drawn = oracle::plane_case(random, law, oracle::Rounding::to_float);
    q.ray = drawn.ray;
    put(q, drawn.shape.point);
    put(q, drawn.shape.normal);
  }

  [[nodiscard]] ExactAnswer answer(const Asked& q) const override {
    if (q.has_left) return {};
    const auto met = oracle::plane(q.ray, {at(q.planes), at(q.planes + 3)});
    const double away = length(q.ray.origin - at(q.planes)) + length(at(q.planes));
    const bool is_seen = is_in_scale(length(at(q.planes + 3))) && (away == 0 || is_in_scale(away));
    return outside_band(met, met.margin >= 1e-7 && is_seen);
  }

  [[nodiscard]] Promises promises() const override { return {0.5, 1, {}}; }

  [[nodiscard]] Vec3 normal(const double* planes, const Vec3&) const override { return at(planes + 3); }

  [[nodiscard]] Geometry geometry(const double* planes) const override {
    const Vec3 normal = at(planes + 3);
    const auto [along_u, along_v] = orthonormal_basis(normalized(normal));
    return Plane{at(planes), normal, along_u, along_v};
  }

  [[nodiscard]] std::vector<Generator> generators() const override { return plane_generators; }
};

}  // namespace

const ShapeProof& plane_proof() {
  static const PlaneProof proof;
  return proof;
}

}  // namespace strahl::selftest
