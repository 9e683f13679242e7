// SPDX-License-Identifier: MIT
// t of one box that is hit, exact before it is rounded, for the few that box_t_lanes.h cannot tell. One lane.

/// (plane - o) / d along an axis on which the ray moves.
FN real slab_exact_t(const Ray* ray, int axis, real plane) {
  real zero = R(0.0), at = component(ray->o, axis), along = component(ray->d, axis), q = (plane - at) / along;
  real off = R(0x1p-22) * real_abs(q);
  ExactCase one;
  one.o = vec3(at, zero, zero);
  one.d = vec3(along, zero, zero);
  one.a = vec3(plane, zero, zero);
  one.b = vec3(R(1.0), zero, zero);
  one.c = one.b;
  one.r = zero;
  // q is within 1.5 u of itself, if not denormal.
  if (!(R(0x1p-100) < real_abs(plane - at) && R(0x1p-100) < real_abs(q))) off = exact_nothing();
  return exact_plane_t(&one, q - off, q + off);
}

/// The first entry or exit from t_min on; the exit of a box that the ray has left. prim: the box's own planes, `stride`
/// apart.
FN real box_exact_t(const Ray* ray, GLOBAL const real* prim, int stride, int is_departed) {
  real t = R(0.0);
  for (int side = is_departed; side < 2; ++side) {
    t = side == 0 ? -REAL_MAX : REAL_MAX;
    for (int axis = 0; axis < 3; ++axis) {
      int near = axis == 0 ? ray->near_x : axis == 1 ? ray->near_y : ray->near_z;
      if (component(ray->d, axis) == R(0.0)) continue;
      real at = slab_exact_t(ray, axis, prim[(near ^ side) * stride]);
      t = side == 0 ? (t < at ? at : t) : (at < t ? at : t);
    }
    if (ray->t_min <= t) break;
  }
  return t;
}
