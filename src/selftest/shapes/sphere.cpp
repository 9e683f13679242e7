// SPDX-License-Identifier: MIT
#include "oracle/oracle.h"
#include "selftest/proof_parts.h"

namespace strahl::selftest {
namespace {

class SphereProof : public ShapeProof {
 public:
  void draw(Question& q, oracle::Random& random, oracle::Law law) const override {
    const auto drawn = oracle::sphere_case(random, law, oracle::Rounding::to_float);
    q.ray = drawn.ray;
    put(q, drawn.shape.center);
    put(q, drawn.shape.radius);
  }

  [[nodiscard]] ExactAnswer answer(const Asked& q) const override {
    const oracle::Sphere shape{at(q.planes), q.planes[3]};
    const double away = length(q.ray.origin - shape.center);
    if (q.has_left) {
      const oracle::Vector<mpq_class> d(q.ray.direction);
      const auto f = oracle::Vector<mpq_class>(q.ray.origin) - oracle::Vector<mpq_class>(shape.center);
      ExactAnswer answer = other_root(q.ray, mpq_class(-2 * oracle::dot(f, d) / oracle::dot(d, d)));
      answer.is_promised = is_in_scale(shape.radius) && is_in_scale(away);
      return answer;
    }
    const auto met = oracle::sphere(q.ray, shape);
    const bool is_seen = shape.radius >= 1e-7 * away && is_in_scale(shape.radius) && is_in_scale(shape.radius + away);
    ExactAnswer answer = outside_band(met, is_seen && std::fabs(met.margin) > 4 * u);
    answer.t_rounding = 16 * u * u * reach(q.ray, shape.center, shape.radius);
    return answer;
  }

  [[nodiscard]] Promises promises() const override {
    using oracle::Law;
    return {0.5, 1, {Law::aimed, Law::offset, Law::unnormalised}};
  }

  [[nodiscard]] Vec3 normal(const double* planes, const Vec3& p) const override { return p - at(planes); }

  void expect_leaving(Question& q, Precision precision) const override {
    const Long f = Long(q.ray.origin) - Long(at(q.planes.data())), d(q.ray.direction);
    const long double along = dot(f, d);
    if (std::fabs(along) > lost_of_product(precision) * std::sqrt(dot(f, f) * dot(d, d)))
      expect_root(q, -2 * along / dot(d, d));
  }

  [[nodiscard]] Geometry geometry(const double* planes) const override {
    Sphere sphere;
    sphere.center = at(planes);
    sphere.radius = planes[3];
    return sphere;
  }

  [[nodiscard]] std::vector<Generator> generators() const override { return sphere_generators; }
};

}  // namespace

const ShapeProof& sphere_proof() {
  static const SphereProof proof;
  return proof;
}

}  // namespace strahl::selftest
