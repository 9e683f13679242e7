// SPDX-License-Identifier: MIT
// Discriminant as (d.d) r^2 - |f x d|^2: equal to b^2 - a c, and the filter loses less in it.
#include "oracle/quadratic.h"

namespace strahl::oracle {
namespace {

template <class N>
QuadricAnswer solve(const Ray& ray, const Sphere& shape) {
  const Vector<N> d(ray.direction), f = Vector<N>(ray.origin) - Vector<N>(shape.center);
  const Vector<N> moment = cross(f, d);
  const N r(shape.radius), a = dot(d, d), ar2 = a * r * r;
  const Quadratic<N> roots{a, dot(f, d), N(dot(f, f) - r * r), N(ar2 - dot(moment, moment))};

  QuadricAnswer answer;
  answer.discriminant_sign = sign(roots.discriminant);
  answer.margin = ratio(roots.discriminant, ar2);
  if (answer.discriminant_sign < 0) return answer;
  answer.root = {root_value(roots, Root::near), root_value(roots, Root::far)};
  answer.on_shape = {true, true};
  answer.range_margin = std::fmin(range_gap(ray, answer.root[0]), range_gap(ray, answer.root[1]));
  const bool is_near = in_range(ray, roots, Root::near);
  answer.hit = is_near || in_range(ray, roots, Root::far);
  answer.t = answer.root[is_near ? 0 : 1];
  return answer;
}

}  // namespace

QuadricAnswer sphere(const Ray& ray, const Sphere& shape, Arithmetic arithmetic) {
  if (is_zero(ray.direction) || !(shape.radius > 0)) return {};
  return decide(arithmetic, [&]<class N>() { return solve<N>(ray, shape); });
}

}  // namespace strahl::oracle
