// SPDX-License-Identifier: MIT
// LANES rays that share their way through the tree, one a lane, and what all of them have in common. One width; no
// guard. Each lane is prepared by the operations of core/ray.h, so it has the bits of that ray alone.
#include "core/nearest.h"

/// 1: rays need not be alike: nothing but lists, of kinds that ask for nothing that is common to all rays, nor for all
/// of them one by one.
enum {
  LANED(PACKET_OF_ANY_RAYS) = (HAS_TREE == 0)
#if !TIER_ROBUST
#define SHAPE(name, planes) &(LANED(PACKET_BODY_##name) != PACKET_BODY_NONE)
#include "shapes/shapes.def"
#undef SHAPE
#endif
#if REAL_BITS == 64
                              & 0
#endif
};

/// Bounds over all lanes, per axis, in the order of near and far.
typedef struct {
  real o_near, o_far;   ///< Of o: the one that the near plane is farther from, and the other.
  real inv_lo, inv_hi;  ///< Of 1 / d; both 0 along an axis that says nothing.
  real slack;           ///< At least every lane's.
} LANED(Bounds);

typedef struct {
  const LANED(Rays) * rays;
  int stop_at_first;  ///< Any hit will do.

  real3w o, d, inv, slack, shear;
  maskw is_x, is_y;  ///< Lanes whose largest axis is x or y.
  realw t_min;
#if TIER_COMPENSATED
  realw dd, dd_inverse, t_per_length;
#endif
  intw left, aim;  ///< What is in no instance.
  maskw outward;
  int has_left;  ///< A lane has left something of it.

  // The nearest hits so far, as in core/nearest.h.
  realw t;
  intw id, kind, slot, instance;
  realw bound;  ///< Nothing that begins beyond can be the nearest hit.
#if TIER_ROBUST
  // Hits that are certain but for the last digits of t.
  realw rough, rough_least;  ///< t roughly, and the least that it may be.
  intw rough_id, rough_kind, rough_slot;
#endif

  // In common, where rays need be alike. Each lies within first ... last.
  real first, last;
  int near_x, near_y, near_z, kx, ky, kz;
  LANED(Bounds) x, y, z;
} LANED(Packet);

FN realw LANED(component_w)(const real3w* v, int axis) { return axis == 0 ? v->x : (axis == 1 ? v->y : v->z); }

/// Whether all lanes of m are alike.
FN int LANED(is_common)(maskw m) { return !any_w(m) || !any_w(~m); }

FN LANED(Bounds) LANED(axis_bounds)(realw o, realw inv, realw slack, int is_backward) {
  LANED(Bounds) b;
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

/// Whether packet_make has found a ray that may hit something, and all such rays alike; else there is no packet.
enum { LANED(PACKET_DEAD), LANED(PACKET_ALIKE), LANED(PACKET_MIXED) };

/// Nothing hit.
FN void LANED(packet_none)(LANED(Packet) * p) {
  p->t = splat_w(R(0.0));
  p->id = splat_int_w(INT_MAX_ID);
  p->kind = p->slot = p->instance = splat_int_w(-1);
#if TIER_ROBUST
  p->rough_kind = splat_int_w(-1);
#endif
}

/// What rays have in common that need be alike. of: those that can hit nothing become others with an empty range.
FN int LANED(packet_common)(LANED(Packet) * p, PRIVATE realw* of, maskw dead) {
  if (any_w(dead)) {
    int lane = first_bit(bits_w(~dead));
    for (int k = 0; k < RAY_PLANES; ++k) {
      real each[LANES];
      store_w(of[k], each);
      if (k != RAY_PLANE_T_MIN && k != RAY_PLANE_T_MAX) of[k] = sel_w(dead, splat_w(each[lane]), of[k]);
    }
  }
  realw zero = splat_w(R(0.0)), kz = of[RAY_PLANE_SHEAR];
  real3w o = LANED(real3_at)(of + RAY_PLANE_O), inv = LANED(real3_at)(of + RAY_PLANE_INV);
  real3w slack = LANED(real3_at)(of + RAY_PLANE_SLACK);
  maskw back_x = lt_w(inv.x, zero), back_y = lt_w(inv.y, zero), back_z = lt_w(inv.z, zero);
  real largest = largest_w(kz);
  if (!(LANED(is_common)(back_x) && LANED(is_common)(back_y) && LANED(is_common)(back_z)) || least_w(kz) != largest)
    return LANED(PACKET_MIXED);
  p->near_x = any_w(back_x) ? 1 : 0;
  p->near_y = any_w(back_y) ? 3 : 2;
  p->near_z = any_w(back_z) ? 5 : 4;
  p->kz = (int)largest;
  p->kx = p->kz == 2 ? 0 : p->kz + 1;
  p->ky = p->kx == 2 ? 0 : p->kx + 1;
  p->x = LANED(axis_bounds)(o.x, inv.x, slack.x, p->near_x & 1);
  p->y = LANED(axis_bounds)(o.y, inv.y, slack.y, p->near_y & 1);
  p->z = LANED(axis_bounds)(o.z, inv.z, slack.z, p->near_z & 1);
  p->first = least_w(of[RAY_PLANE_T_MIN]);
  p->last = largest_w(of[RAY_PLANE_T_MAX]);
  return LANED(PACKET_ALIKE);
}

/// of: prepared and widened.
FN int LANED(packet_make)(LANED(Packet) * p, LANED(Rays) * of, int stop_at_first) {
  PRIVATE realw* rays = of->planes;
  maskw dead = lt_w(rays[RAY_PLANE_T_MAX], rays[RAY_PLANE_T_MIN]);
  if (!any_w(~dead)) return LANED(PACKET_DEAD);
  int is_any = LANED(PACKET_OF_ANY_RAYS);
  int found = is_any ? LANED(PACKET_ALIKE) : LANED(packet_common)(p, rays, dead);
  if (found == LANED(PACKET_MIXED)) return found;

  p->rays = of;
  p->stop_at_first = stop_at_first;
  p->o = LANED(real3_at)(rays + RAY_PLANE_O);
  p->d = LANED(real3_at)(rays + RAY_PLANE_D);
  p->inv = LANED(real3_at)(rays + RAY_PLANE_INV);
  p->slack = LANED(real3_at)(rays + RAY_PLANE_SLACK);
  p->shear = LANED(real3_at)(rays + RAY_PLANE_SHEAR + 1);
  p->is_x = eq_w(rays[RAY_PLANE_SHEAR], splat_w(R(0.0)));
  p->is_y = eq_w(rays[RAY_PLANE_SHEAR], splat_w(R(1.0)));
  p->t_min = rays[RAY_PLANE_T_MIN];
#if TIER_COMPENSATED
  p->dd = rays[RAY_PLANE_DD];
  p->dd_inverse = rays[RAY_PLANE_DD + 2];
  p->t_per_length = rays[RAY_PLANE_DD + 3];
#endif
  p->left = TIER_FAST ? splat_int_w(-1) : of->left;
  if (HAS_INSTANCES) p->left = sel_int_w(lt_int_w(of->left_instance, splat_int_w(0)), p->left, splat_int_w(-1));
  p->aim = of->aim;
  p->outward = nonzero_w(of->is_outward);
  p->has_left = any_w(nonzero_w(p->left - splat_int_w(-1)));
  LANED(packet_none)(p);
  p->t = p->bound = rays[RAY_PLANE_T_MAX];
  return found;
}

FN Ray LANED(packet_ray)(const LANED(Packet) * p, int lane) { return LANED(ray_of)(p->rays, lane); }

/// The nearest hits, lane by lane.
typedef struct {
  real t[LANES];
  int id[LANES], kind[LANES], slot[LANES], instance[LANES];
} LANED(NearestEach);

FN LANED(NearestEach) LANED(packet_open)(const LANED(Packet) * p) {
  LANED(NearestEach) each;
  store_w(p->t, each.t);
  store_int_w(p->id, each.id);
  store_int_w(p->kind, each.kind);
  store_int_w(p->slot, each.slot);
  store_int_w(p->instance, each.instance);
  return each;
}

FN void LANED(packet_close)(LANED(Packet) * p, const LANED(NearestEach) * each) {
  p->t = read_w(each->t);
  p->id = read_int_w(each->id);
  p->kind = read_int_w(each->kind);
  p->slot = read_int_w(each->slot);
  p->instance = read_int_w(each->instance);
  p->bound = min_w(p->t, p->bound);
}

FN Nearest LANED(nearest_of)(const LANED(NearestEach) * each, int lane) {
  Nearest n = nearest_none(each->t[lane]);
  n.id = each->id[lane];
  n.kind = each->kind[lane];
  n.slot = each->slot[lane];
  n.instance = each->instance[lane];
  return n;
}

FN void LANED(nearest_to)(LANED(NearestEach) * each, int lane, Nearest n) {
  each->t[lane] = n.t;
  each->id[lane] = n.id;
  each->kind[lane] = n.kind;
  each->slot[lane] = n.slot;
  each->instance[lane] = n.instance;
}

/// nearest_take in lanes.
FN void LANED(packet_take)(LANED(Packet) * p, maskw hit, realw t, intw id, intw kind, intw slot) {
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
FN maskw LANED(packet_left)(const LANED(Packet) * p, int id) { return ~nonzero_w(p->left - splat_int_w(id)); }

/// Of a flat primitive: lanes that have just left it or end on it.
FN maskw LANED(packet_end)(const LANED(Packet) * p, int id) {
  return LANED(packet_left)(p, id) | ~nonzero_w(p->aim - splat_int_w(id));
}

#if !TIER_ROBUST
FN void LANED(packet_settle)(const Scene* scene, LANED(Packet) * p) {
  (void)scene;
  (void)p;
}

FN void LANED(packet_finish)(const Scene* scene, LANED(Packet) * p, int may_be_rough) {
  (void)scene;
  (void)p;
  (void)may_be_rough;
}
#endif
