// SPDX-License-Identifier: MIT
// Surfaces of LANES spheres, one a lane: sphere_surface of sphere.h in lanes, operation by operation. Textured spheres
// are left to that function. One width; no guard.

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

/// As flat_surfaces_w.
FN maskw sphere_surfaces_w(const Scene* scene, const SurfaceHits_w* hits, maskw which, int kind, int planes,
                           Surfaces_w* s) {
  which = which & ~nonzero_w(hits->kind - splat_int_w(kind));
  if (!any_w(which)) return which;
  GLOBAL const real* spheres = scene->geometry + scene_shape_row(scene, kind)[SHAPE_GEOMETRY];
  intw at = hit_places_w(scene, hits, which, kind, planes, s);
  real3w center = gather_corner_w(spheres, at, 0);
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
  p = hit_point_to_world_w(scene, hits, p);
  normal = hit_normal_to_world_w(scene, hits, normal);
#if TIER_FAST
  p = fma3_w(hits->world_t, hits->world_d, hits->world_o);
#endif
  maskw plain = which & finite3_w(p) & finite3_w(normal) & finite_w(facing);
  if (TEXTURE_COUNT > 0) plain = plain & lt_int_w(part_entry_w(scene, s, PART_UV_RATES), splat_int_w(0));
  take_surfaces_w(scene, hits, plain, p, normal, facing, splat_w(R(0.0)), s);
  s->is_round = sel_int_w(plain, splat_int_w(1), s->is_round);
  return plain;
}
