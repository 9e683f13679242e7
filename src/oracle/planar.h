// SPDX-License-Identifier: MIT
// o + t d = corner + u edge_u + v edge_v by Cramer's rule; the signs of the numerators over a positive denominator are
// the edge functions of triangle and parallelogram.
#pragma once

#include <initializer_list>
#include <utility>

#include "oracle/number.h"

namespace strahl::oracle {

template <class N>
struct PlanarSolution {
  N denominator;  ///< >= 0; 0 where the ray is parallel or there is no area
  N t, u, v;      ///< numerators
  double cosine = 0;
};

template <class N>
PlanarSolution<N> solve_planar(const Ray& ray, const Vector<N>& corner, const Vector<N>& edge_u,
                               const Vector<N>& edge_v) {
  const Vector<N> d(ray.direction), f = Vector<N>(ray.origin) - corner, normal = cross(edge_u, edge_v);
  const N descent = dot(normal, d);
  const int orientation = sign(descent);
  if (orientation == 0) return {N(0), N(0), N(0), N(0), 0};
  const N flip(orientation);
  const double cosine = ratio(N(flip * descent), N(length(normal) * length(d)));
  return {N(flip * descent), N(-flip * dot(normal, f)), N(flip * dot(f, cross(edge_v, d))),
          N(flip * dot(f, cross(d, edge_u))), cosine};
}

/// An edge function with the two ends of its edge.
template <class N>
struct Edge {
  N inside;
  Vector<N> from, to;
};

/// Fills in what triangle and parallelogram share; edge_sign is in the order of edges.
template <class N>
PlanarAnswer planar_answer(const Ray& ray, const PlanarSolution<N>& s, std::initializer_list<Edge<N>> edges) {
  PlanarAnswer answer;
  const Vector<N> o(ray.origin), d(ray.direction);
  answer.is_parallel = false;
  answer.cosine = s.cosine;
  answer.u = ratio(s.u, s.denominator);
  answer.v = ratio(s.v, s.denominator);
  answer.margin = INFINITY;
  int zeros = 0;
  bool is_inside = true;
  std::size_t i = 0;
  for (const Edge<N>& edge : edges) {
    const int side = sign(edge.inside);
    answer.edge_sign[i++] = side;
    zeros += side == 0;
    is_inside = is_inside && side >= 0;
    if (side == 0) {
      answer.margin = std::fmin(answer.margin, 0);
      continue;
    }
    const N scale = N(length(edge.from - o)) * N(length(edge.to - o)) * N(length(d));
    answer.margin = std::fmin(answer.margin, ratio(edge.inside, scale));
  }
  answer.on_edge = is_inside && zeros > 0;
  answer.on_vertex = is_inside && zeros > 1;
  const N t = s.t / s.denominator;
  answer.t = to_exact(t);
  answer.hit = is_inside && in_range(ray, t);
  answer.range_margin = range_gap(ray, answer.t);
  return answer;
}

}  // namespace strahl::oracle
