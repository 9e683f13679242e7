// SPDX-License-Identifier: MIT
#include "selftest/shapes/polygon.h"

namespace strahl::selftest {
namespace {

class TriangleProof : public ShapeProof {
 public:
  void draw(Question& q, oracle::Random& random, oracle::Law law) const override {
    const auto drawn = oracle::triangle_case(random, law, oracle::Rounding::to_float);
    q.ray = drawn.ray;
    for (const Vec3& p : {drawn.shape.p0, drawn.shape.p1, drawn.shape.p2}) put(q, p);
  }

  [[nodiscard]] ExactAnswer answer(const Asked& q) const override {
    if (q.has_left) return {};
    const oracle::Triangle shape{at(q.planes), at(q.planes + 3), at(q.planes + 6)};
    return answer_of_polygon(q, oracle::triangle(q.ray, shape), 3, 0);
  }

  [[nodiscard]] Promises promises() const override { return promises_of_polygon(); }

  [[nodiscard]] Vec3 normal(const double* planes, const Vec3&) const override {
    return cross(at(planes + 3) - at(planes), at(planes + 6) - at(planes));
  }

  [[nodiscard]] Geometry geometry(const double* planes) const override {
    return Triangle{at(planes), at(planes + 3), at(planes + 6)};
  }

  [[nodiscard]] std::vector<Generator> generators() const override {
    std::vector<Generator> all = triangle_generators;
    all.insert(all.end(), mesh_generators.begin(), mesh_generators.end());
    return all;
  }
};

}  // namespace

const ShapeProof& triangle_proof() {
  static const TriangleProof proof;
  return proof;
}

}  // namespace strahl::selftest
