// SPDX-License-Identifier: MIT
// The hits of LANES rays, as `strahl intersect` reports them: describe_one of trace_one.h in lanes where the shape has
// a body (shapes/all_surfaces_lanes.h), with its bits. After trace_one.h and, where lanes are wide, accel/packet.h. One
// width; no guard.
#define REPORTS_HITS 1
#if LANES != 1
#include "math/sampling_lanes.h"
#include "hits/surfaces_lanes.h"
#include "hits/shape_surfaces_lanes.h"

/// ray_given_t of rays/ray.h.
FN realw rays_given_t_w(const Rays_w* rays, realw t, realw t_min, realw t_max) {
  t = t * rays->planes[RAY_PLANE_T_FROM_SCALED];
  t = sel_w(lt_w(t, t_min), t_min, t);
  return sel_w(lt_w(t_max, t), t_max, t);
}

/// Writes the hits of the lanes of `which` to a block's planes, misses in the other lanes.
FN void write_hits_w(const Scene* scene, const Surfaces_w* s, const HitParameters_w* at, maskw which, realw t,
                     GLOBAL real* out, GLOBAL int* ids) {
  realw zero = splat_w(R(0.0));
  intw none = splat_int_w(-1), shape = none, primitive = none;
  if (any_w(which)) {  // There is a part.
    shape = part_entry_w(scene, s, PART_SHAPE);
    primitive = s->id - part_entry_w(scene, s, PART_FIRST_ID);
  }
  write_w(sel_w(which, t, splat_w(miss_t_w())), out + HIT_T * LANES);
  write_w(sel_w(which, at->u, zero), out + HIT_U * LANES);
  write_w(sel_w(which, at->v, zero), out + HIT_V * LANES);
  write_w(sel_w(which, s->normal.x, zero), out + HIT_NORMAL * LANES);
  write_w(sel_w(which, s->normal.y, zero), out + (HIT_NORMAL + 1) * LANES);
  write_w(sel_w(which, s->normal.z, zero), out + (HIT_NORMAL + 2) * LANES);
  write_int_w(sel_int_w(which, s->instance, none), ids + HIT_INSTANCE * LANES);
  write_int_w(sel_int_w(which, shape, none), ids + HIT_SHAPE * LANES);
  write_int_w(sel_int_w(which, primitive, none), ids + HIT_PRIMITIVE * LANES);
}
#endif

/// The block of rays and hits that find_rays was given; count: number of rays in it.
FN void describe_w(const Scene* scene, GLOBAL const real* in, GLOBAL const int* departed, int count,
                   GLOBAL const real* t, GLOBAL const int* found, GLOBAL real* out, GLOBAL int* ids) {
#if LANES == 1
  (void)count;
  describe_one_w(scene, in, departed, *t, found, out, ids);
#else
  Rays_w rays;
  rays_given_w(scene, in, departed, &rays);
  intw none = splat_int_w(-1);
  NearestEach_w each;
  each.t = load_w(t);
  each.id = load_int_w(found + FOUND_ID * LANES);
  each.kind = load_int_w(found + FOUND_KIND * LANES);
  each.slot = load_int_w(found + FOUND_SLOT * LANES);
  each.instance = HAS_INSTANCES ? load_int_w(found + FOUND_INSTANCE * LANES) : none;
  Surfaces_w s = surfaces_none_w();
  s.hit = first_lanes_w(count) & ~lt_int_w(each.kind, splat_int_w(0));
  SurfaceHits_w hits = surface_hits_w(scene, &rays, &each, s.hit);
  HitParameters_w at;
  maskw plain = shape_surfaces_w(scene, &hits, &s, &at);
  realw given = rays_given_t_w(&rays, each.t, load_w(in + RAY_T_MIN * LANES), load_w(in + RAY_T_MAX * LANES));
  write_hits_w(scene, &s, &at, plain, given, out, ids);
  for (uint lanes = bits_w(s.hit & ~plain); lanes != 0u; lanes &= lanes - 1u) {
    int i = first_bit(lanes);
    describe_one_w(scene, in + i, departed + i, t[i], found + i, out + i, ids + i);
  }
#endif
}
