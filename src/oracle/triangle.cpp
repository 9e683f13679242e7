// SPDX-License-Identifier: MIT
#include "oracle/planar.h"

namespace strahl::oracle {
namespace {

template <class N>
PlanarAnswer solve(const Ray& ray, const Triangle& shape) {
  const Vector<N> p0(shape.p0), p1(shape.p1), p2(shape.p2);
  const PlanarSolution<N> s = solve_planar(ray, p0, p1 - p0, p2 - p0);
  if (sign(s.denominator) == 0) {
    PlanarAnswer parallel;
    parallel.margin = 0;
    return parallel;
  }
  return planar_answer<N>(ray, s, {{N(s.denominator - s.u - s.v), p1, p2}, {s.u, p2, p0}, {s.v, p0, p1}});
}

}  // namespace

PlanarAnswer triangle(const Ray& ray, const Triangle& shape, Arithmetic arithmetic) {
  return decide(arithmetic, [&]<class N>() { return solve<N>(ray, shape); });
}

}  // namespace strahl::oracle
