// SPDX-License-Identifier: MIT
#include "selftest/shapes/polygon.h"

namespace strahl::selftest {
namespace {

class ParallelogramProof : public ShapeProof {
 public:
  /// Four corners are packed, each rounded.
  void draw(Question& q, oracle::Random& random, oracle::Law law) const override {
    const auto drawn = oracle::parallelogram_case(random, law, oracle::Rounding::to_float);
    const oracle::Parallelogram& given = drawn.shape;
    q.ray = drawn.ray;
    put(q, given.corner);
    put(q, given.corner + given.edge_u);
    put(q, given.corner + given.edge_u + given.edge_v);
    put(q, given.corner + given.edge_v);
  }

  /// Four rounded corners need not form a parallelogram: the band grows by the gap, and nothing is promised for shapes
  /// that the gap distorts.
  [[nodiscard]] ExactAnswer answer(const Asked& q) const override {
    if (q.has_left) return {};
    const Vec3 a = at(q.planes), c = at(q.planes + 6);
    const oracle::Parallelogram shape{a, at(q.planes + 3) - a, at(q.planes + 9) - a};
    const double gap = length(a + shape.edge_u + shape.edge_v - c);
    const double longest = std::fmax(length(shape.edge_u), length(shape.edge_v));
    const double height = length(cross(shape.edge_u, shape.edge_v)) / longest;
    const double closes = gap == 0 ? 0 : 4 * gap / length(c - q.ray.origin);
    ExactAnswer answer = answer_of_polygon(q, oracle::parallelogram(q.ray, shape), 4, closes);
    if (gap > 0x1p-10 * height) answer.is_promised = false;
    return answer;
  }

  [[nodiscard]] Promises promises() const override { return promises_of_polygon(); }

  [[nodiscard]] Vec3 normal(const double* planes, const Vec3&) const override {
    return cross(at(planes + 3) - at(planes), at(planes + 9) - at(planes));
  }

  [[nodiscard]] Geometry geometry(const double* planes) const override {
    return Rectangle{at(planes), at(planes + 3) - at(planes), at(planes + 9) - at(planes)};
  }

  [[nodiscard]] std::vector<Generator> generators() const override { return parallelogram_generators; }
};

}  // namespace

const ShapeProof& parallelogram_proof() {
  static const ParallelogramProof proof;
  return proof;
}

}  // namespace strahl::selftest
