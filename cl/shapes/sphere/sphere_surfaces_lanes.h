// SPDX-License-Identifier: MIT
// Surfaces of LANES spheres, one a lane: sphere_surface of sphere.h in lanes, operation by operation. One width; no
// guard.
#include "math/atan2_lanes.h"

/// sphere_outward_from_afar. f: o - center.
FN real3w sphere_outward_each_w(const SurfaceHits_w* hits, real3w center, real3w f, realw radius, maskw is_far) {
  real3w d = hits->d, o = hits->o;
  real3w rest = vec3_w(difference_rest_w(o.x, center.x, f.x), difference_rest_w(o.y, center.y, f.y),
                       difference_rest_w(o.z, center.z, f.z));
  realw dd = dot3_w(d, d), zero = splat_w(R(0.0));
  real3w moment = add3_w(cross3_w(f, d), cross3_w(rest, d));
  real3w l = scale3_w(splat_w(R(1.0)) / dd, cross3_w(d, moment));
  realw distance = sqrt_w(dot3_w(l, l));
  realw square = (radius - distance) * (radius + distance) / dd;
  realw half_chord = sel_w(lt_w(zero, square), sqrt_w(square), zero);
  return fma3_w(sel_w(is_far, half_chord, -half_chord), d, l);
}

/// Where the lanes of `which` are in their spheres' own frames, and how u and v change there. normal: outwards, in the
/// frame of the group, as the gradients.
FN void sphere_coordinates_w(const Scene* scene, maskw which, real3w normal, realw radius, Surfaces_w* s,
                             HitParameters_w* parameters) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), two = splat_w(R(2.0)), turn = splat_w(ONE_OVER_TWO_PI);
  realw frame[9];
  gather_frame_w(scene, s, 9, frame);
  real3w axis_x = real3_at_w(frame), axis_y = real3_at_w(frame + 3), axis_z = real3_at_w(frame + 6);
  realw x = dot3_w(normal, axis_x), y = dot3_w(normal, axis_y), z = dot3_w(normal, axis_z);
  real3w around = fma3_w(x, axis_y, scale3_w(-y, axis_x));
  if (HAS_TANGENT) s->along = sel3_w(which, around, s->along);
  realw sine = sqrt_w(fma_w(x, x, y * y));
  if (HAS_RELIEF) {
    maskw is_off_pole = which & lt_w(zero, sine);
    realw divisor = sel_w(is_off_pole, sine, one), inverse = one / divisor;
    real3w outward = scale3_w(inverse, fma3_w(x, axis_x, scale3_w(y, axis_y)));
    real3w grad_u = scale3_w(turn / (radius * divisor), scale3_w(inverse, around));
    real3w grad_v = scale3_w(two * turn / radius, fma3_w(z, outward, scale3_w(-sine, axis_z)));
    s->grad_u = sel3_w(is_off_pole, grad_u, s->grad_u);
    s->grad_v = sel3_w(is_off_pole, grad_v, s->grad_v);
  }
  if (ASKS_COORDINATES_w) take_coordinates_w(which, atan2_turns_w(y, x), two * atan2_turns_w(sine, z), parameters);
}

/// As flat_surfaces.
FN maskw sphere_surfaces_w(const Scene* scene, const SurfaceHits_w* hits, maskw which, GLOBAL const real* spheres,
                           intw at, Surfaces_w* s, HitParameters_w* parameters) {
  real3w center = gather_planes3_w(spheres, at, 0, SCENE_LANES);
  realw radius = gather_w(spheres + 3 * SCENE_LANES, at), t = hits->t;
  real3w f = sub3_w(hits->o, center), out = fma3_w(t, hits->d, f);
  realw facing = dot3_w(out, hits->d);
#if !TIER_FAST
  maskw is_distant = lt_w(splat_w(R(16.0)) * radius * radius, dot3_w(f, f));
  if (any_w(which & is_distant)) {
    realw past = t + dot3_w(f, hits->d) / dot3_w(hits->d, hits->d), one = splat_w(R(1.0));
    maskw is_far = lt_w(splat_w(R(8.0) * real_roundoff()) * abs_w(t), past);
    out = sel3_w(is_distant, sphere_outward_each_w(hits, center, f, radius, is_far), out);
    facing = sel_w(is_distant, sel_w(is_far, one, -one), facing);
  }
#endif
  real3w normal = normalize3_w(out), p = fma3_w(radius, normal, center);
  realw bound = -round_departure_bound_w(scene, hits, radius);
  maskw plain = take_own_surfaces_w(scene, hits, which, p, normal, facing, bound, s);
  if (ASKS_COORDINATES_w + HAS_TANGENT + HAS_RELIEF > 0)
    sphere_coordinates_w(scene, plain, normal, radius, s, parameters);
  s->is_round = sel_int_w(plain, splat_int_w(1), s->is_round);
  return plain;
}
