// SPDX-License-Identifier: MIT
// Which rays of a packet come near primitives that have no body for packets. One width; no guard.

/// prim: a primitive of the kind, its reals LANES apart.
FN Ball ball_around_w(GLOBAL const real* prim, int kind) {
#define SHAPE(name, planes) \
  if (kind == SHAPE_##name) return name##_ball_w(prim);
#include "shapes/shapes.def"
#undef SHAPE
  (void)kind;
  return ball_of_all(load3(prim));
}

#if TIER_ROBUST
/// within_reach of reach_lanes.h with the roles exchanged: a ray a lane and one ball.
FN maskw near_ball_w(const Packet_w* p, Ball ball) {
  Reaching_w rays;
  rays.dx = p->d.x;
  rays.dy = p->d.y;
  rays.dz = p->d.z;
  rays.dd_inverse = p->dd_inverse;
  rays.t_per_length = p->t_per_length;
  rays.t_min = p->t_min;
  rays.t_max = p->bound;
  return reaches_ball_w(&rays, p->o.x - splat_w(ball.centre.x), p->o.y - splat_w(ball.centre.y),
                        p->o.z - splat_w(ball.centre.z), splat_w(ball.radius));
}
#endif

/// The rays of `active` that may meet a primitive of the block.
FN maskw rays_near_w(const Packet_w* p, GLOBAL const real* block, GLOBAL const int* ids, int kind, maskw active) {
#if TIER_ROBUST
  maskw far_off = active;
  uint prims = bits_w(is_there_w(ids));
  for (; prims != 0u && any_w(far_off); prims &= prims - 1u)
    far_off = far_off & ~near_ball_w(p, ball_around_w(block + first_bit(prims), kind));
  return active & ~far_off;
#else
  (void)p;
  (void)block;
  (void)ids;
  (void)kind;
  return active;
#endif
}
