// SPDX-License-Identifier: MIT
// LANES rays that traverse the tree together, one a lane, and bounds over all of them. One width; no guard. Each lane
// is prepared by the operations of rays/ray.h, so it has the same bits as the ray by itself.
#include "hits/nearest.h"

/// 1: the rays need not be coherent: the scene has only lists, of kinds whose bodies need no bounds over all rays and
/// do not test all rays one by one.
enum {
  PACKET_OF_ANY_RAYS_w = (HAS_TREE == 0)
#if !TIER_ROBUST
#define SHAPE(name, planes) &(PACKET_BODY_##name##_w != PACKET_BODY_NONE)
#include "shapes/shapes.def"
#undef SHAPE
#endif
#if REAL_BITS == 64
                         & 0
#endif
};

/// Bounds over all lanes, per axis, in the order of near and far.
typedef struct {
  real o_near, o_far;   ///< Of o: the end of the range farther from the near plane, and the other end.
  real inv_lo, inv_hi;  ///< Of 1 / d; both 0 along an axis that says nothing.
  real slack;           ///< At least every lane's.
} Bounds_w;

typedef struct {
  const Rays_w* rays;
  int stop_at_first;  ///< Any hit will do.

  real3w o, d, inv, slack, shear;
  maskw is_x, is_y;  ///< Lanes whose largest axis is x or y.
  realw t_min;
#if TIER_COMPENSATED
  realw dd, dd_inverse, t_per_length;
#endif
  intw departed, aim;  ///< Primitives that are in no instance.
  maskw outward;
  int has_departed;  ///< A lane has left something of it.

  // The nearest hits so far, as in hits/nearest.h.
  realw t;
  intw id, kind, slot, instance;
  realw bound;  ///< Nothing that begins beyond can be the nearest hit.
#if TIER_ROBUST
  // Hits that are certain except for the last digits of t.
  realw approximate, approximate_least;  ///< t roughly, and the least that it may be.
  intw approximate_id, approximate_kind, approximate_slot;
#endif

  // Bounds over all rays, where these must be coherent. Each ray lies within first ... last.
  real first, last;
  int near_x, near_y, near_z, kx, ky, kz;
  Bounds_w x, y, z;
} Packet_w;

FN realw component_w(const real3w* v, int axis) { return axis == 0 ? v->x : (axis == 1 ? v->y : v->z); }

/// Whether all lanes of m are equal.
FN int is_common_w(maskw m) { return !any_w(m) || !any_w(~m); }

FN Bounds_w axis_bounds_w(realw o, realw inv, realw slack, int is_backward) {
  Bounds_w b;
  real lo = least_w(o), hi = largest_w(o);
  b.o_near = is_backward ? lo : hi;
  b.o_far = is_backward ? hi : lo;
  b.inv_lo = least_w(inv);
  b.inv_hi = largest_w(inv);
  b.slack = largest_w(slack);
  // A lane does not move along this axis, or all but.
  if (!(real_is_finite(b.inv_lo) & real_is_finite(b.inv_hi) & real_is_finite(b.slack))) {
    b.inv_lo = b.inv_hi = R(0.0);
    b.slack = REAL_MAX;
  }
  return b;
}

/// Whether packet_make has found a ray that may hit something, and all such rays are coherent; else there is no packet.
enum { PACKET_DEAD_w, PACKET_ALIKE_w, PACKET_MIXED_w };

/// Nothing hit.
FN void packet_none_w(Packet_w* p) {
  p->t = splat_w(R(0.0));
  p->id = splat_int_w(INT_MAX_ID);
  p->kind = p->slot = p->instance = splat_int_w(-1);
#if TIER_ROBUST
  p->approximate_kind = splat_int_w(-1);
#endif
}

/// Sets the bounds over all rays, where these must be coherent. of: rays that can hit nothing are replaced by others
/// with an empty range.
FN int packet_common_w(Packet_w* p, PRIVATE realw* of, maskw dead) {
  if (any_w(dead)) {
    int lane = first_bit(bits_w(~dead));
    for (int k = 0; k < RAY_PLANES; ++k) {
      real each[LANES];
      store_w(of[k], each);
      if (k != RAY_PLANE_T_MIN && k != RAY_PLANE_T_MAX) of[k] = sel_w(dead, splat_w(each[lane]), of[k]);
    }
  }
  realw zero = splat_w(R(0.0)), kz = of[RAY_PLANE_SHEAR];
  real3w o = real3_at_w(of + RAY_PLANE_O), inv = real3_at_w(of + RAY_PLANE_INV);
  real3w slack = real3_at_w(of + RAY_PLANE_SLACK);
  maskw back_x = lt_w(inv.x, zero), back_y = lt_w(inv.y, zero), back_z = lt_w(inv.z, zero);
  real largest = largest_w(kz);
  if (!(is_common_w(back_x) && is_common_w(back_y) && is_common_w(back_z)) || least_w(kz) != largest)
    return PACKET_MIXED_w;
  p->near_x = any_w(back_x) ? 1 : 0;
  p->near_y = any_w(back_y) ? 3 : 2;
  p->near_z = any_w(back_z) ? 5 : 4;
  p->kz = (int)largest;
  p->kx = p->kz == 2 ? 0 : p->kz + 1;
  p->ky = p->kx == 2 ? 0 : p->kx + 1;
  p->x = axis_bounds_w(o.x, inv.x, slack.x, p->near_x & 1);
  p->y = axis_bounds_w(o.y, inv.y, slack.y, p->near_y & 1);
  p->z = axis_bounds_w(o.z, inv.z, slack.z, p->near_z & 1);
  p->first = least_w(of[RAY_PLANE_T_MIN]);
  p->last = largest_w(of[RAY_PLANE_T_MAX]);
  return PACKET_ALIKE_w;
}

/// of: prepared and widened.
FN int packet_make_w(Packet_w* p, Rays_w* of, int stop_at_first) {
  PRIVATE realw* rays = of->planes;
  maskw dead = lt_w(rays[RAY_PLANE_T_MAX], rays[RAY_PLANE_T_MIN]);
  if (!any_w(~dead)) return PACKET_DEAD_w;
  int is_any = PACKET_OF_ANY_RAYS_w;
  int found = is_any ? PACKET_ALIKE_w : packet_common_w(p, rays, dead);
  if (found == PACKET_MIXED_w) return found;

  p->rays = of;
  p->stop_at_first = stop_at_first;
  p->o = real3_at_w(rays + RAY_PLANE_O);
  p->d = real3_at_w(rays + RAY_PLANE_D);
  p->inv = real3_at_w(rays + RAY_PLANE_INV);
  p->slack = real3_at_w(rays + RAY_PLANE_SLACK);
  p->shear = real3_at_w(rays + RAY_PLANE_SHEAR + 1);
  p->is_x = eq_w(rays[RAY_PLANE_SHEAR], splat_w(R(0.0)));
  p->is_y = eq_w(rays[RAY_PLANE_SHEAR], splat_w(R(1.0)));
  p->t_min = rays[RAY_PLANE_T_MIN];
#if TIER_COMPENSATED
  p->dd = rays[RAY_PLANE_DD];
  p->dd_inverse = rays[RAY_PLANE_DD + 2];
  p->t_per_length = rays[RAY_PLANE_DD + 3];
#endif
  p->departed = TIER_FAST ? splat_int_w(-1) : of->departed;
  if (HAS_INSTANCES)
    p->departed = sel_int_w(lt_int_w(of->departed_instance, splat_int_w(0)), p->departed, splat_int_w(-1));
  p->aim = of->aim;
  p->outward = nonzero_w(of->is_outward);
  p->has_departed = any_w(nonzero_w(p->departed - splat_int_w(-1)));
  packet_none_w(p);
  p->t = p->bound = rays[RAY_PLANE_T_MAX];
  return found;
}

FN Ray packet_ray_w(const Packet_w* p, int lane) { return ray_of_w(p->rays, lane); }

/// The nearest hits, lane by lane.
typedef struct {
  real t[LANES];
  int id[LANES], kind[LANES], slot[LANES], instance[LANES];
} NearestEach_w;

FN NearestEach_w packet_open_w(const Packet_w* p) {
  NearestEach_w each;
  store_w(p->t, each.t);
  store_int_w(p->id, each.id);
  store_int_w(p->kind, each.kind);
  store_int_w(p->slot, each.slot);
  store_int_w(p->instance, each.instance);
  return each;
}

FN void packet_close_w(Packet_w* p, const NearestEach_w* each) {
  p->t = read_w(each->t);
  p->id = read_int_w(each->id);
  p->kind = read_int_w(each->kind);
  p->slot = read_int_w(each->slot);
  p->instance = read_int_w(each->instance);
  p->bound = min_w(p->t, p->bound);
}

FN Nearest nearest_of_w(const NearestEach_w* each, int lane) {
  Nearest n = nearest_none(each->t[lane]);
  n.id = each->id[lane];
  n.kind = each->kind[lane];
  n.slot = each->slot[lane];
  n.instance = each->instance[lane];
  return n;
}

FN void nearest_to_w(NearestEach_w* each, int lane, Nearest n) {
  each->t[lane] = n.t;
  each->id[lane] = n.id;
  each->kind[lane] = n.kind;
  each->slot[lane] = n.slot;
  each->instance[lane] = n.instance;
}

/// nearest_take in lanes.
FN void packet_take_w(Packet_w* p, maskw hit, realw t, intw id, intw kind, intw slot) {
  maskw is_before = lt_int_w(id, p->id);
  if (HAS_INSTANCES) is_before = is_before | ~lt_int_w(p->instance, splat_int_w(0));
  maskw closer = hit & (lt_w(t, p->t) | (eq_w(t, p->t) & is_before));
  p->t = sel_w(closer, t, p->t);
  p->id = sel_int_w(closer, id, p->id);
  p->kind = sel_int_w(closer, kind, p->kind);
  p->slot = sel_int_w(closer, slot, p->slot);
  if (HAS_INSTANCES) p->instance = sel_int_w(closer, splat_int_w(-1), p->instance);
  p->bound = min_w(p->t, p->bound);
}

/// Lanes that have just left the primitive.
FN maskw packet_departed_w(const Packet_w* p, int id) { return ~nonzero_w(p->departed - splat_int_w(id)); }

/// Of a flat primitive: lanes that have just left it or end on it.
FN maskw packet_end_w(const Packet_w* p, int id) {
  return packet_departed_w(p, id) | ~nonzero_w(p->aim - splat_int_w(id));
}

#if !TIER_ROBUST
FN void packet_settle_w(const Scene* scene, Packet_w* p) {
  (void)scene;
  (void)p;
}

FN void packet_finish_w(const Scene* scene, Packet_w* p, int may_be_approximate) {
  (void)scene;
  (void)p;
  (void)may_be_approximate;
}
#endif
