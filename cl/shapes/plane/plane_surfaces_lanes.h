// SPDX-License-Identifier: MIT
// Surfaces of LANES planes, one a lane: plane_surface of plane.h in lanes, operation by operation. One width; no guard.

/// As flat_surfaces.
FN maskw plane_surfaces_w(const Scene* scene, const SurfaceHits_w* hits, maskw which, GLOBAL const real* anchors,
                          intw at, Surfaces_w* s, HitParameters_w* parameters) {
  realw zero = splat_w(R(0.0));
  real3w normal = normalize3_w(gather_planes3_w(anchors, at, 3, SCENE_LANES)), p = fma3_w(hits->t, hits->d, hits->o);
  maskw plain = take_own_surfaces_w(scene, hits, which, p, normal, dot3_w(normal, hits->d), zero, s);
  if (ASKS_COORDINATES_w + HAS_TANGENT + HAS_RELIEF == 0) return plain;
  realw frame[9];
  gather_frame_w(scene, s, 9, frame);
  real3w dual_u = real3_at_w(frame), dual_v = real3_at_w(frame + 3);
  real3w from_origin = fma3_w(hits->t, hits->d, sub3_w(hits->o, real3_at_w(frame + 6)));
  if (HAS_TANGENT) {
    real3w across = cross3_w(dual_v, normal);
    s->along = sel3_w(plain, sel3_w(lt_w(dot3_w(across, dual_u), zero), negate3_w(across), across), s->along);
  }
  if (HAS_RELIEF) {
    s->grad_u = sel3_w(plain, dual_u, s->grad_u);
    s->grad_v = sel3_w(plain, dual_v, s->grad_v);
  }
  take_coordinates_w(plain, dot3_w(from_origin, dual_u), dot3_w(from_origin, dual_v), parameters);
  return plain;
}
