// SPDX-License-Identifier: MIT
// LANES rays that traverse the tree together, one a lane, and bounds over all of them. One width; no guard. Each lane
// is prepared by the operations of rays/ray.h, so it has the same bits as the ray by itself.
#include "hits/nearest.h"

/// 1: packets are faster than single rays even where nothing is known of the rays: the scene has only lists, of kinds
/// whose bodies do not test all rays one by one.
enum {
  PACKET_OF_ANY_RAYS_w = (HAS_TREE == 0)
#if !TIER_ROBUST
#define SHAPE(name, planes) &(PACKET_BODY_##name##_w < PACKET_BODY_CYLINDER)
#include "shapes/shapes.def"
#undef SHAPE
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
  int is_alike;       ///< The directions have the same signs, so that the bounds below are known; see is_alike_w.

  real3w o, d, inv, slack, shear;
  maskw is_x, is_y;              ///< Lanes whose largest axis is x or y.
  int axis;                      ///< The largest axis of all rays that can hit something, 0, 1, 2; -1: they differ.
  real3w turned_o;               ///< o, its axes turned so that the largest is z (shear_for_each_w).
  maskw back_x, back_y, back_z;  ///< Lanes that move towards smaller x, y, z.
  realw t_min;
#if TIER_COMPENSATED
  realw dd, dd_inverse, t_per_length;
#endif
  intw departed, aim;  ///< Primitives that are in no instance.
  maskw outward;
  int has_departed;  ///< A lane has left something of it,
  int has_ends;      ///< or a lane ends on something of it.

  // The nearest hits so far, as in hits/nearest.h.
  realw t;
  intw id, kind, slot, instance;
  realw bound;  ///< Nothing that begins beyond can be the nearest hit.
#if TIER_ROBUST
  // Hits that are certain except for the last digits of t.
  realw approximate, approximate_least;  ///< t roughly, and the least that it may be.
  intw approximate_id, approximate_kind, approximate_slot;
#endif

  // Bounds over all rays, where these are alike. Each ray lies within first ... last.
  real first, last;
  int near_x, near_y, near_z;
  Bounds_w x, y, z;
} Packet_w;

/// Lists are short, so that bounds over all rays do not pay there.
FN int is_alike_w(const Packet_w* p) { return HAS_TREE && p->is_alike; }

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

/// Nothing hit.
FN void packet_none_w(Packet_w* p) {
  p->t = splat_w(R(0.0));
  p->id = splat_int_w(INT_MAX_ID);
  p->kind = p->slot = p->instance = splat_int_w(-1);
#if TIER_ROBUST
  p->approximate_kind = splat_int_w(-1);
#endif
}

/// v, with the value of a lane that is not dead in the lanes that are.
FN realw common_w(realw v, maskw dead, int lane) { return sel_w(dead, splat_w(get_w(&v, lane)), v); }

/// Sets the bounds over all rays that can hit something, if their directions have the same signs.
FN void packet_bound_w(Packet_w* p, maskw dead, realw t_max) {
  real3w o = p->o, inv = p->inv, slack = p->slack;
  if (any_w(dead)) {
    int lane = first_bit(bits_w(~dead));
    o = vec3_w(common_w(o.x, dead, lane), common_w(o.y, dead, lane), common_w(o.z, dead, lane));
    inv = vec3_w(common_w(inv.x, dead, lane), common_w(inv.y, dead, lane), common_w(inv.z, dead, lane));
    slack = vec3_w(common_w(slack.x, dead, lane), common_w(slack.y, dead, lane), common_w(slack.z, dead, lane));
  }
  realw zero = splat_w(R(0.0));
  maskw back_x = lt_w(inv.x, zero), back_y = lt_w(inv.y, zero), back_z = lt_w(inv.z, zero);
  p->is_alike = is_common_w(back_x) && is_common_w(back_y) && is_common_w(back_z);
  if (!p->is_alike) return;
  p->near_x = any_w(back_x) ? 1 : 0;
  p->near_y = any_w(back_y) ? 3 : 2;
  p->near_z = any_w(back_z) ? 5 : 4;
  p->x = axis_bounds_w(o.x, inv.x, slack.x, p->near_x & 1);
  p->y = axis_bounds_w(o.y, inv.y, slack.y, p->near_y & 1);
  p->z = axis_bounds_w(o.z, inv.z, slack.z, p->near_z & 1);
  p->first = least_w(p->t_min);
  p->last = largest_w(t_max);
}

/// of: prepared and widened. Returns 0 where no ray can hit anything.
FN int packet_make_w(Packet_w* p, Rays_w* of, int stop_at_first) {
  PRIVATE realw* rays = of->planes;
  realw zero = splat_w(R(0.0));
  maskw dead = lt_w(rays[RAY_PLANE_T_MAX], rays[RAY_PLANE_T_MIN]);
  if (!any_w(~dead)) return 0;
  p->rays = of;
  p->stop_at_first = stop_at_first;
  p->o = real3_at_w(rays + RAY_PLANE_O);
  p->d = real3_at_w(rays + RAY_PLANE_D);
  p->inv = real3_at_w(rays + RAY_PLANE_INV);
  p->slack = real3_at_w(rays + RAY_PLANE_SLACK);
  p->shear = real3_at_w(rays + RAY_PLANE_SHEAR + 1);
  p->is_x = eq_w(rays[RAY_PLANE_SHEAR], zero);
  p->is_y = eq_w(rays[RAY_PLANE_SHEAR], splat_w(R(1.0)));
  maskw others_x = ~(p->is_x | dead), others_y = ~(p->is_y | dead);
  p->axis = !any_w(others_x) ? 0 : !any_w(others_y) ? 1 : !any_w((p->is_x | p->is_y) & ~dead) ? 2 : -1;
  p->turned_o = turned3_w(p->is_x, p->is_y, p->o);
  p->back_x = lt_w(p->inv.x, zero);
  p->back_y = lt_w(p->inv.y, zero);
  p->back_z = lt_w(p->inv.z, zero);
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
  p->has_ends = p->has_departed | (!TIER_FAST && any_w(nonzero_w(p->aim - splat_int_w(-1))));
  packet_none_w(p);
  p->t = p->bound = rays[RAY_PLANE_T_MAX];
  p->is_alike = 0;
  if (HAS_TREE) packet_bound_w(p, dead, rays[RAY_PLANE_T_MAX]);
  return 1;
}

FN Ray packet_ray_w(const Packet_w* p, int lane) { return ray_of_w(p->rays, lane); }
