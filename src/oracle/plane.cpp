// SPDX-License-Identifier: MIT
#include "oracle/number.h"

namespace strahl::oracle {
namespace {

template <class N>
Answer solve(const Ray& ray, const Plane& shape) {
  const Vector<N> d(ray.direction), n(shape.normal);
  const N descent = dot(n, d);
  Answer answer;
  answer.margin = 0;
  if (sign(descent) == 0) return answer;
  answer.margin = std::sqrt(ratio(N(descent * descent), N(dot(n, n) * dot(d, d))));
  const N t = dot(n, Vector<N>(shape.point) - Vector<N>(ray.origin)) / descent;
  answer.hit = in_range(ray, t);
  answer.t = to_exact(t);
  answer.range_margin = range_gap(ray, answer.t);
  return answer;
}

}  // namespace

Answer plane(const Ray& ray, const Plane& shape, Arithmetic arithmetic) {
  return decide(arithmetic, [&]<class N>() { return solve<N>(ray, shape); });
}

}  // namespace strahl::oracle
