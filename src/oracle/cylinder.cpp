// SPDX-License-Identifier: MIT
// With v the axis, |(f + t d) x v|^2 = r^2 v.v is the sphere's equation for the vectors f x v and d x v. The place of a
// root along the axis is linear in t, so its comparison with the two ends is again a sign of P + Q sqrt(D).
#include "oracle/quadratic.h"

namespace strahl::oracle {
namespace {

template <class N>
QuadricAnswer solve(const Ray& ray, const Cylinder& shape) {
  const Vector<N> d(ray.direction), v(shape.axis), f = Vector<N>(ray.origin) - Vector<N>(shape.p0);
  const Vector<N> across = cross(d, v), from = cross(f, v), moment = cross(from, across);
  const N a = dot(across, across), v2 = dot(v, v), limit = N(shape.radius) * N(shape.radius) * v2;
  if (sign(a) == 0) return {};
  const N b = dot(from, across);
  // |from x across|^2 = |from|^2 |across|^2 - b^2 (Lagrange).
  const Quadratic<N> roots{a, b, N(dot(from, from) - limit), N(a * limit - dot(moment, moment))};

  QuadricAnswer answer;
  answer.discriminant_sign = sign(roots.discriminant);
  answer.margin = ratio(roots.discriminant, N(a * limit));
  if (answer.discriminant_sign < 0) return answer;

  // Place along the axis times a v.v at t = (-b +- sqrt(D)) / a, which is base +- slope sqrt(D).
  const N slope = dot(d, v), base = a * dot(f, v) - b * slope, length = a * v2;
  double margin = answer.margin;
  for (const Root root : {Root::near, Root::far}) {
    const auto i = static_cast<std::size_t>(root == Root::far);
    const N signed_slope = N(static_cast<int>(root)) * slope;
    answer.root[i] = root_value(roots, root);
    answer.on_shape[i] = sign_with_root(base, signed_slope, roots.discriminant) >= 0 &&
                         sign_with_root(N(base - length), signed_slope, roots.discriminant) <= 0;
    const N t = N(answer.root[i].value) + N(answer.root[i].rest);
    const N place = dot(f, v) + t * slope;
    margin = std::fmin(margin, std::fmin(std::fabs(ratio(place, v2)), std::fabs(ratio(N(v2 - place), v2))));
    if (!answer.on_shape[i]) continue;
    answer.range_margin = std::fmin(answer.range_margin, range_gap(ray, answer.root[i]));
    if (answer.hit || !in_range(ray, roots, root)) continue;
    answer.hit = true;
    answer.t = answer.root[i];
  }
  answer.margin = answer.on_shape[0] || answer.on_shape[1] ? margin : -margin;
  return answer;
}

}  // namespace

QuadricAnswer cylinder(const Ray& ray, const Cylinder& shape, Arithmetic arithmetic) {
  if (is_zero(ray.direction) || is_zero(shape.axis) || !(shape.radius > 0)) return {};
  return decide(arithmetic, [&]<class N>() { return solve<N>(ray, shape); });
}

}  // namespace strahl::oracle
