// SPDX-License-Identifier: MIT
// The hit point times the denominator of t has polynomial coordinates, so its distance from the centre is compared with
// the radius without a division.
#include "oracle/number.h"

namespace strahl::oracle {
namespace {

template <class N>
Answer solve(const Ray& ray, const Disk& shape) {
  const Vector<N> d(ray.direction), f = Vector<N>(ray.origin) - Vector<N>(shape.center);
  const Vector<N> normal = cross(Vector<N>(shape.axis_u), Vector<N>(shape.axis_v));
  const N descent = dot(normal, d), height = dot(normal, f), r(shape.radius);
  if (sign(descent) == 0) return {};
  const Vector<N> scaled_offset = descent * f - height * d;
  const N limit = r * r * descent * descent, slack = limit - dot(scaled_offset, scaled_offset);

  Answer answer;
  answer.margin = ratio(slack, limit);
  const N t = -height / descent;
  answer.t = to_exact(t);
  answer.range_margin = range_gap(ray, answer.t);
  answer.hit = sign(slack) >= 0 && in_range(ray, t);
  return answer;
}

}  // namespace

Answer disk(const Ray& ray, const Disk& shape, Arithmetic arithmetic) {
  if (!(shape.radius > 0)) return {};
  return decide(arithmetic, [&]<class N>() { return solve<N>(ray, shape); });
}

}  // namespace strahl::oracle
