// SPDX-License-Identifier: MIT
#include "oracle/oracle.h"
#include "selftest/proof_parts.h"

namespace strahl::selftest {
namespace {

class CylinderProof : public ShapeProof {
 public:
  /// The axis is what the device holds: a unit vector, rounded, times the length, rounded.
  void draw(Question& q, oracle::Random& random, oracle::Law law) const override {
    const auto drawn = oracle::cylinder_case(random, law, oracle::Rounding::to_float);
    q.ray = drawn.ray;
    put(q, drawn.shape.p0);
    put(q, normalized(drawn.shape.axis));
    put(q, length(drawn.shape.axis));
    put(q, drawn.shape.radius);
  }

  [[nodiscard]] ExactAnswer answer(const Asked& q) const override {
    const Vec3 p0 = at(q.planes), unit = at(q.planes + 3);
    const double extent = q.planes[6];
    const oracle::Cylinder shape{p0, extent * unit, q.planes[7]};
    const double sine = length(cross(normalized(q.ray.direction), normalized(unit)));
    if (q.has_left) {
      using Exactly = oracle::Vector<mpq_class>;
      const Exactly v(unit), d(q.ray.direction), f = Exactly(q.ray.origin) - Exactly(p0), across = oracle::cross(d, v);
      if (sgn(oracle::dot(across, across)) == 0) return {};
      const mpq_class t = -2 * oracle::dot(oracle::cross(f, v), across) / oracle::dot(across, across);
      const mpq_class place = oracle::dot(f, v) + t * oracle::dot(d, v), end = mpq_class(extent) * oracle::dot(v, v);
      ExactAnswer answer = other_root(q.ray, t);
      answer.hit = answer.hit && sgn(place) >= 0 && place <= end;
      const double margin = std::fmin(std::fabs(place.get_d()), std::fabs(mpq_class(end - place).get_d())) / extent;
      answer.is_promised =
          margin > 4 * u && is_in_scale(q.planes[7]) && is_in_scale(length(q.ray.origin - p0) + extent);
      answer.t_rounding = 32 * u * u * reach(q.ray, p0, 0) / sine;
      return answer;
    }
    const auto met = oracle::cylinder(q.ray, shape);
    const double away = length(q.ray.origin - p0), size = std::fmin(shape.radius, extent);
    const bool is_seen = size >= 1e-6 * away && is_in_scale(size) && is_in_scale(shape.radius + extent + away);
    ExactAnswer answer = outside_band(met, is_seen && std::fabs(met.margin) > 4 * u);
    answer.t_rounding =
        16 * u * u * reach(q.ray, p0, extent + shape.radius) / (sine * std::sqrt(std::fabs(met.margin)));
    // A crossing at the end of the range, where t is 0 except for rounding.
    if (met.discriminant_sign >= 0)
      for (const auto& root : met.root)
        if (std::fabs(root.value - q.ray.t_min) <= answer.t_rounding) answer.is_promised = false;
    return answer;
  }

  [[nodiscard]] Promises promises() const override { return {0.5, 1, {}}; }

  [[nodiscard]] Vec3 normal(const double* planes, const Vec3& p) const override {
    const Vec3 from = p - at(planes), unit = at(planes + 3);
    return from - dot(from, unit) * unit;
  }

  /// Whether the other root is clearly away from the mantle's ends.
  void expect_leaving(Question& q, Precision precision) const override {
    const double* planes = q.planes.data();
    const Long f = Long(q.ray.origin) - Long(at(planes)), d(q.ray.direction), v(at(planes + 3));
    const Long from = cross(f, v), across = cross(d, v);
    const long double inner = dot(from, across), a = dot(across, across);
    if (!(a > 0x1p-20L * dot(d, d) * dot(v, v))) return;
    if (!(std::fabs(inner) > lost_of_product(precision) * std::sqrt(dot(f, f) * dot(d, d)) * dot(v, v))) return;
    const long double other = -2 * inner / a;
    const long double place = dot(f + other * d, v) / (static_cast<long double>(q.planes[6]) * dot(v, v));
    if (other > 0 && std::fabs(place - 0.5L) > 0.49L && std::fabs(place - 0.5L) < 0.51L) return;
    const bool is_met = other > 0 && std::fabs(place - 0.5L) < 0.5L;
    expect_root(q, is_met ? other : -1);
    q.t_rounding = static_cast<double>(32 * u * u * std::sqrt(dot(from, from) / a));
  }

  [[nodiscard]] Geometry geometry(const double* planes) const override {
    const Vec3 p0 = at(planes), unit = at(planes + 3);
    return Cylinder{p0, p0 + planes[6] * unit, planes[7], orthonormal_basis(normalized(unit))[0]};
  }

  [[nodiscard]] std::vector<Generator> generators() const override { return cylinder_generators; }
};

}  // namespace

const ShapeProof& cylinder_proof() {
  static const CylinderProof proof;
  return proof;
}

}  // namespace strahl::selftest
