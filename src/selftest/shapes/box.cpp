// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include "oracle/oracle.h"
#include "selftest/proof_parts.h"

namespace strahl::selftest {
namespace {

oracle::Aabb box_of(const double* planes) {
  return {{planes[0], planes[2], planes[4]}, {planes[1], planes[3], planes[5]}};
}

class BoxProof : public ShapeProof {
 public:
  void draw(Question& q, oracle::Random& random, oracle::Law law) const override {
    const auto drawn = oracle::aabb_case(random, law, oracle::Rounding::to_float);
    const oracle::Aabb& s = drawn.shape;
    q.ray = drawn.ray;
    for (const double x : {s.min.x, s.max.x, s.min.y, s.max.y, s.min.z, s.max.z}) put(q, x);
  }

  [[nodiscard]] ExactAnswer answer(const Asked& q) const override {
    const auto met = oracle::aabb(q.ray, box_of(q.planes));
    // The robust tier has no band; the band of double is its own rounding.
    if (!q.has_left) return outside_band(met, met.margin == 0 || std::fabs(met.margin) > 0x1p-50);
    ExactAnswer answer;
    answer.t = met.exit;
    answer.hit = met.line_meets && met.exit.value > 0 && met.exit.value <= q.ray.t_max;
    return answer;
  }

  [[nodiscard]] Promises promises() const override { return {0.5, 1, {oracle::Law::exact_border}, 2}; }

  /// Rays that graze are drawn about one axis, whichever face they leave.
  [[nodiscard]] Vec3 normal(const double*, const Vec3&) const override { return {1, 0, 0}; }

  /// The face that was left is the nearest one. Nothing is expected where two faces are about equally near.
  void expect_leaving(Question& q, Precision) const override {
    const Vec3 &o = q.ray.origin, &d = q.ray.direction;
    const std::array origin{o.x, o.y, o.z}, along{d.x, d.y, d.z};
    std::array<double, 6> away{};
    for (std::size_t i = 0; i < 6; ++i) away[i] = std::fabs(q.planes[i] - origin[i / 2]);
    const std::size_t nearest = static_cast<std::size_t>(std::min_element(away.begin(), away.end()) - away.begin());
    const double size = std::max({std::fabs(o.x), std::fabs(o.y), std::fabs(o.z)});
    for (std::size_t i = 0; i < 6; ++i)
      if (i != nearest && away[i] <= away[nearest] + 64 * u * size) return;
    const double inward = nearest % 2 == 0 ? along[nearest / 2] : -along[nearest / 2];
    if (inward <= 0) return expect_root(q, -1);
    oracle::Ray line = q.ray;
    line.t_min = -INFINITY;
    const auto answer = oracle::aabb(line, box_of(q.planes.data()));
    if (!answer.line_meets || std::fabs(answer.margin) < 4 * u || !(answer.exit.value > 0)) return;
    q.expected = Expected::hit;
    q.primitive = 0;
    q.t = answer.exit;
  }

  [[nodiscard]] Geometry geometry(const double* planes) const override {
    const oracle::Aabb box = box_of(planes);
    return Box{box.min, box.max};
  }

  [[nodiscard]] std::vector<Generator> generators() const override { return box_generators; }
};

}  // namespace

const ShapeProof& box_proof() {
  static const BoxProof proof;
  return proof;
}

}  // namespace strahl::selftest
