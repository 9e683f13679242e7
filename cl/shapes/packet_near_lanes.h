// SPDX-License-Identifier: MIT
// Which rays of a packet come near primitives that have no body for packets. One width; no guard.

#if TIER_ROBUST
/// A ball around a primitive.
typedef struct {
  real x, y, z, radius;
} LANED(Ball);

/// prim: its reals, LANES apart.
FN LANED(Ball) LANED(ball_around)(GLOBAL const real* prim, int body) {
  LANED(Ball) ball;
  if (body == PACKET_BODY_NEAR_BOX) {
    real3 lo = vec3(prim[0], prim[2 * LANES], prim[4 * LANES]),
          hi = vec3(prim[LANES], prim[3 * LANES], prim[5 * LANES]);
    real3 across = sub3(hi, lo), middle = fma3(R(0.5), across, lo);
    ball.x = middle.x;
    ball.y = middle.y;
    ball.z = middle.z;
    // And what the middle and the diagonal are rounded by.
    real largest = max3(abs3(lo)) + max3(abs3(hi)), diagonal = max3(abs3(across));
    ball.radius = real_fma(R(0x1p-20), largest, R(0.5) * length3(across)) + R(0x1p-20) * diagonal;
  } else {
    ball.x = prim[0];
    ball.y = prim[LANES];
    ball.z = prim[2 * LANES];
    ball.radius = body == PACKET_BODY_NEAR_DISK ? real_sqrt(prim[6 * LANES]) : prim[7 * LANES] + prim[6 * LANES];
  }
  return ball;
}

/// within_reach of reach_lanes.h with the roles exchanged: a ray a lane and one ball.
FN maskw LANED(near_ball)(const LANED(Packet) * p, LANED(Ball) ball) {
  LANED(Reaching) rays;
  rays.dx = p->d.x;
  rays.dy = p->d.y;
  rays.dz = p->d.z;
  rays.dd_inverse = p->dd_inverse;
  rays.t_per_length = p->t_per_length;
  rays.t_min = p->t_min;
  rays.t_max = p->bound;
  return LANED(reaches_ball)(&rays, p->o.x - splat_w(ball.x), p->o.y - splat_w(ball.y), p->o.z - splat_w(ball.z),
                             splat_w(ball.radius));
}
#endif

/// The rays of `active` that may meet a primitive of the block.
FN maskw LANED(rays_near)(const LANED(Packet) * p, GLOBAL const real* block, GLOBAL const int* ids, int body,
                          maskw active) {
#if TIER_ROBUST
  maskw far_off = active;
  uint prims = bits_w(LANED(is_there)(ids));
  for (; prims != 0u && any_w(far_off); prims &= prims - 1u)
    far_off = far_off & ~LANED(near_ball)(p, LANED(ball_around)(block + first_bit(prims), body));
  return active & ~far_off;
#else
  (void)p;
  (void)block;
  (void)ids;
  (void)body;
  return active;
#endif
}
