// SPDX-License-Identifier: MIT
#include "oracle/planar.h"

namespace strahl::oracle {
namespace {

template <class N>
PlanarAnswer solve(const Ray& ray, const Parallelogram& shape) {
  const Vector<N> corner(shape.corner), edge_u(shape.edge_u), edge_v(shape.edge_v);
  const Vector<N> end_u = corner + edge_u, end_v = corner + edge_v, opposite = end_u + edge_v;
  const PlanarSolution<N> s = solve_planar(ray, corner, edge_u, edge_v);
  if (sign(s.denominator) == 0) {
    PlanarAnswer parallel;
    parallel.margin = 0;
    return parallel;
  }
  return planar_answer<N>(ray, s,
                          {{s.u, end_v, corner},
                           {N(s.denominator - s.u), end_u, opposite},
                           {s.v, corner, end_u},
                           {N(s.denominator - s.v), opposite, end_v}});
}

}  // namespace

PlanarAnswer parallelogram(const Ray& ray, const Parallelogram& shape, Arithmetic arithmetic) {
  return decide(arithmetic, [&]<class N>() { return solve<N>(ray, shape); });
}

}  // namespace strahl::oracle
