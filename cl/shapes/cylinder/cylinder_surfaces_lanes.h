// SPDX-License-Identifier: MIT
// Surfaces of LANES cylinders, one a lane: cylinder_surface of cylinder.h in lanes, operation by operation. One width;
// no guard.
#include "math/atan2_lanes.h"

/// As flat_surfaces.
FN maskw cylinder_surfaces_w(const Scene* scene, const SurfaceHits_w* hits, maskw which, GLOBAL const real* cylinders,
                             intw at, Surfaces_w* s, HitParameters_w* parameters) {
  real3w p0 = gather_planes3_w(cylinders, at, 0, SCENE_LANES), axis = gather_planes3_w(cylinders, at, 3, SCENE_LANES);
  GLOBAL const real* lengths = cylinders + 6 * SCENE_LANES;
  realw length = gather_w(lengths, at), radius = gather_w(lengths + SCENE_LANES, at);
  real3w from_p0 = fma3_w(hits->t, hits->d, sub3_w(hits->o, p0));
  realw along = dot3_w(from_p0, axis), zero = splat_w(R(0.0)), one = splat_w(R(1.0));
  real3w normal = normalize3_w(fma3_w(-along, axis, from_p0));
  real3w p = add3_w(fma3_w(radius, normal, scale3_w(along, axis)), p0);
  realw bound = -round_departure_bound_w(scene, hits, length + radius);
  maskw plain = take_own_surfaces_w(scene, hits, which, p, normal, dot3_w(normal, hits->d), bound, s);
  s->is_round = sel_int_w(plain, splat_int_w(1), s->is_round);
  if (HAS_TANGENT) s->along = sel3_w(plain, cross3_w(axis, normal), s->along);
  if (HAS_RELIEF) {
    s->grad_u = sel3_w(plain, scale3_w(splat_w(ONE_OVER_TWO_PI) / radius, cross3_w(axis, normal)), s->grad_u);
    s->grad_v = sel3_w(plain, scale3_w(one / length, axis), s->grad_v);
  }
  if (!ASKS_COORDINATES_w) return plain;
  realw frame[6], v = along / length;
  gather_frame_w(scene, s, 6, frame);
  realw u = atan2_turns_w(dot3_w(normal, real3_at_w(frame + 3)), dot3_w(normal, real3_at_w(frame)));
  take_coordinates_w(plain, u, sel_w(lt_w(zero, v), sel_w(lt_w(v, one), v, one), zero), parameters);
  return plain;
}
