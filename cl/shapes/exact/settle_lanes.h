// SPDX-License-Identifier: MIT
// Exact t of hits that were put off (put_off.h), LANES rays at a time, each with a primitive of its own. Robust tier,
// more than one lane. One width; no guard.
#include "shapes/exact/near_hits_lanes.h"
#include "shapes/polygon/polygon_exact_lanes.h"
#include "shapes/sphere/sphere_exact_lanes.h"

/// Lanes settle spheres too: put_off.h, which a unit includes once, must have been included for more than one lane.
typedef char lanes_settle_spheres[SPHERES_WAIT ? 1 : -1];

/// Hits whose exact t is still to be computed, one a lane.
typedef struct {
  maskw which;  ///< Lanes that have one, and of it
  intw kind, slot;
  realw approximate;
} PutOff_w;

FN void exact_rays_w(const Rays_w* rays, ExactRays_w* exact) {
  PRIVATE const realw* planes = rays->planes;
  exact->o = real3_at_w(planes + RAY_PLANE_O);
  exact->d = real3_at_w(planes + RAY_PLANE_D);
  exact->t_min = planes[RAY_PLANE_T_MIN];
  exact->dd = planes[RAY_PLANE_DD];
  exact->dd_rest = planes[RAY_PLANE_DD + 1];
  exact->dd_inverse = planes[RAY_PLANE_DD + 2];
  exact->shear_z = planes[RAY_PLANE_SHEAR + 3];
  exact->is_x = eq_w(planes[RAY_PLANE_SHEAR], splat_w(R(0.0)));
  exact->is_y = eq_w(planes[RAY_PLANE_SHEAR], splat_w(R(1.0)));
}

/// t of one kind. put_off->which: its lanes, not none; other lanes are undefined.
FN realw settled_kind_w(const Scene* scene, const Rays_w* rays, const PutOff_w* put_off, int kind, int body,
                        int planes) {
  maskw which = put_off->which, plain;
  GLOBAL const real* geometry = scene->geometry + scene_shape_row(scene, kind)[SHAPE_GEOMETRY];
  // Lanes besides `which` take the first primitive.
  intw slot = sel_int_w(which, put_off->slot, splat_int_w(0)), lane = slot % LANES, at = (slot - lane) * planes + lane;
  ExactRays_w exact;
  exact_rays_w(rays, &exact);
  realw approximate = put_off->approximate, t;
  real3w a = gather_planes3_w(geometry, at, 0, LANES);
  if (SPHERES_ARE_PUT_OFF && body == PACKET_BODY_SPHERE) {
    t = sphere_root_w(&exact, a, gather_w(geometry + 3 * LANES, at), which, &plain);
  } else {
    int last = body == PACKET_BODY_TRIANGLE ? 2 : 3;
    real3w b = gather_planes3_w(geometry, at, 3, LANES), c = gather_planes3_w(geometry, at, 6, LANES);
    real3w d = last == 2 ? c : gather_planes3_w(geometry, at, 9, LANES);
    realw least, most;
    polygon_range_w(&exact, a, b, d, &least, &most);
    t = within_polygon_w(&exact, least, a, b, d, c);
    maskw is_told = eq_w(least, most) | is_before_w(&exact, most, a, b, d, c);
    plain = is_told & is_plain_w(&exact, a, b, d);
  }
  uint others = body == PACKET_BODY_SPHERE ? 0u : bits_w(which & ~plain);
  if (others == 0u) return t;
  real ts[LANES], approximates[LANES];
  int slots[LANES];
  store_int_w(slot, slots);
  store_w(t, ts);
  store_w(approximate, approximates);
  int points = body == PACKET_BODY_TRIANGLE ? 3 : 4;
  for (; others != 0u; others &= others - 1u) {
    int i = first_bit(others), slot = slots[i];
    GLOBAL const real* prim = geometry + (ulong)(slot / LANES) * (ulong)(planes * LANES) + slot % LANES;
    Ray ray = ray_of_w(rays, i);
    ts[i] = exact_t(&ray, approximates[i], prim, points, LANES);
  }
  return read_w(ts);
}

/// Lanes of put_off->which: the exact t. Others are undefined.
FN realw settled_w(const Scene* scene, const Rays_w* rays, const PutOff_w* put_off) {
  realw t = put_off->approximate;
  PutOff_w kind = *put_off;
  (void)scene;  // For a scene without these kinds.
  (void)rays;
  (void)kind;
#define SHAPE(name, planes)                                                                                            \
  if ((int)PACKET_BODY_##name##_w < (int)PACKET_BODY_PLANE) {                                                          \
    kind.which = put_off->which & ~nonzero_w(put_off->kind - splat_int_w(SHAPE_##name));                               \
    realw of_kind = t;                                                                                                 \
    if (any_w(kind.which)) of_kind = settled_kind_w(scene, rays, &kind, SHAPE_##name, PACKET_BODY_##name##_w, planes); \
    t = sel_w(kind.which, of_kind, t);                                                                                 \
  }
#include "shapes/shapes.def"
#undef SHAPE
  return t;
}
