// SPDX-License-Identifier: MIT
// Surfaces of LANES disks, one a lane: disk_surface of disk.h in lanes, operation by operation. One width; no guard.
#include "math/atan2_lanes.h"

/// As flat_surfaces.
FN maskw disk_surfaces_w(const Scene* scene, const SurfaceHits_w* hits, maskw which, GLOBAL const real* disks, intw at,
                         Surfaces_w* s, HitParameters_w* parameters) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0));
  real3w center = gather_planes3_w(disks, at, 0, SCENE_LANES);
  real3w normal = normalize3_w(gather_planes3_w(disks, at, 3, SCENE_LANES));
  real3w from_center = fma3_w(hits->t, hits->d, sub3_w(hits->o, center)), p = add3_w(from_center, center);
  maskw plain = take_own_surfaces_w(scene, hits, which, p, normal, dot3_w(normal, hits->d), zero, s);
  if (ASKS_COORDINATES_w + HAS_TANGENT + HAS_RELIEF == 0) return plain;
  realw frame[6];
  gather_frame_w(scene, s, 6, frame);
  real3w axis_u = real3_at_w(frame), axis_v = real3_at_w(frame + 3);
  realw x = dot3_w(from_center, axis_u), y = dot3_w(from_center, axis_v);
  if (HAS_TANGENT) s->along = sel3_w(plain, fma3_w(x, axis_u, scale3_w(y, axis_v)), s->along);
  realw u = sqrt_w(fma_w(x, x, y * y));
  u = sel_w(lt_w(one, u), one, u);
  if (HAS_RELIEF) {
    maskw is_off_center = plain & lt_w(zero, u);
    realw inverse = one / sel_w(is_off_center, u, one), turn = splat_w(ONE_OVER_TWO_PI) * inverse;
    realw cosine = x * inverse, sine = y * inverse;
    s->grad_u = sel3_w(is_off_center, fma3_w(cosine, axis_u, scale3_w(sine, axis_v)), s->grad_u);
    real3w around = fma3_w(cosine, axis_v, scale3_w(-sine, axis_u));
    s->grad_v = sel3_w(is_off_center, scale3_w(turn, around), s->grad_v);
  }
  if (ASKS_COORDINATES_w) take_coordinates_w(plain, u, atan2_turns_w(y, x), parameters);
  return plain;
}
