// SPDX-License-Identifier: MIT
// Rays in, hits out: what `strahl intersect` computes per work-item and what the host repeats bit for bit. One width;
// no guard. Where lanes are wide a work-item takes LANES rays: it prepares them together, follows each by itself, and
// describes their hits together (describe_lanes.h).
#include "accel/traverse.h"
#include "math/vec3_lanes.h"
#include "rays/departing_lanes.h"
#include "shapes/shape.h"
#if TIER_ROBUST && LANES != 1
#include "shapes/exact/settle_lanes.h"
#endif

/// to: LANES rays, prepared and widened. in: RAY_REALS planes. departed: DEPARTED_INTS planes, the primitives that the
/// rays have left.
FN void rays_given_w(const Scene* scene, GLOBAL const real* in, GLOBAL const int* departed, Rays_w* to) {
  to->departed = load_int_w(departed + DEPARTED_ID * LANES);
  to->departed_instance = load_int_w(departed + DEPARTED_INSTANCE * LANES);
  to->aim = splat_int_w(-1);
  to->is_outward = splat_int_w(0);
  maskw has_departed = nonzero_w(to->departed - splat_int_w(-1));
  real3w o = load_planes3_w(in + RAY_O * LANES), d = load_planes3_w(in + RAY_D * LANES);
  rays_make_w(o, d, load_w(in + RAY_T_MIN * LANES), load_w(in + RAY_T_MAX * LANES), has_departed, to);
  widen_rays_w(has_departed, to->planes, scene->geometry + scene->index[HEADER_BOUNDS]);
}

/// Stores the hit of ray i in the layout of find_rays.
FN void store_found_w(const Nearest* hit, int i, int stop_at_first, GLOBAL real* t, GLOBAL int* found) {
  if (stop_at_first) {
    found[i] = hit->kind >= 0;
  } else {
    t[i] = hit->t;
    found[FOUND_ID * LANES + i] = hit->id;
    found[FOUND_KIND * LANES + i] = hit->kind;
    found[FOUND_SLOT * LANES + i] = hit->slot;
    if (HAS_INSTANCES) found[FOUND_INSTANCE * LANES + i] = hit->instance;
  }
}

/// Rays and hits are given in blocks of LANES: RAY_REALS planes, and DEPARTED_INTS planes of the primitives that the
/// rays have left. count: number of rays in the block; the others are undefined. found: FOUND_INTS planes, or with
/// stop_at_first a single one, of 1 or 0. t: a plane, undefined where nothing is hit.
FN void find_rays_w(const Scene* scene, GLOBAL const real* in, GLOBAL const int* departed, int count, int stop_at_first,
                    GLOBAL real* t, GLOBAL int* found) {
  Rays_w rays;
  rays_given_w(scene, in, departed, &rays);
#if TIER_ROBUST && LANES != 1
  int waits[LANES], kinds[LANES], slots[LANES], is_any = 0;
  real approximate[LANES], ts[LANES];
  for (int i = 0; i < LANES; ++i) waits[i] = kinds[i] = slots[i] = 0;
  for (int i = 0; i < LANES; ++i) approximate[i] = R(0.0);
  for (int i = 0; i < count; ++i) {
    Ray ray = ray_of_w(&rays, i);
    Nearest hit = traverse_w(scene, &ray, stop_at_first ? FIND_ANY : FIND_NEAREST_PUT_OFF);
    store_found_w(&hit, i, stop_at_first, t, found);
    if (hit.points != 0) {
      is_any = waits[i] = 1;
      kinds[i] = hit.kind;
      slots[i] = hit.slot;
      approximate[i] = hit.approximate;
    }
  }
  if (stop_at_first || !is_any) return;
  PutOff_w put_off;
  put_off.which = nonzero_w(read_int_w(waits));
  put_off.kind = read_int_w(kinds);
  put_off.slot = read_int_w(slots);
  put_off.approximate = read_w(approximate);
  store_w(settled_w(scene, &rays, &put_off), ts);
  for (int i = 0; i < count; ++i)
    if (waits[i]) t[i] = ts[i];
#else
  for (int i = 0; i < count; ++i) {
    Ray ray = ray_of_w(&rays, i);
    Nearest hit = traverse_w(scene, &ray, stop_at_first ? FIND_ANY : FIND_NEAREST);
    store_found_w(&hit, i, stop_at_first, t, found);
  }
#endif
}

/// t of a miss.
FN real miss_t_w(void) { return bits_to_real((bitsr)REAL_EXPONENT_MASK << REAL_EXPONENT_SHIFT); }

/// in ... ids: the numbers of one ray, LANES apart. out, ids: HIT_REALS reals and HIT_INTS ints of the hit that
/// find_rays has found; a miss is infinite, -1, -1, -1 and zeros.
FN void describe_one_w(const Scene* scene, GLOBAL const real* in, GLOBAL const int* departed, real t,
                       GLOBAL const int* found, GLOBAL real* out, GLOBAL int* ids) {
  for (int i = 0; i < HIT_REALS; ++i) out[i * LANES] = R(0.0);
  out[HIT_T * LANES] = miss_t_w();
  for (int i = 0; i < HIT_INTS; ++i) ids[i * LANES] = -1;
  Nearest hit;
  hit.t = t;
  hit.id = found[FOUND_ID * LANES];
  hit.kind = found[FOUND_KIND * LANES];
  hit.slot = found[FOUND_SLOT * LANES];
  hit.instance = HAS_INSTANCES ? found[FOUND_INSTANCE * LANES] : -1;
  if (hit.kind < 0) return;
  real3 o = vec3(in[RAY_O * LANES], in[(RAY_O + 1) * LANES], in[(RAY_O + 2) * LANES]);
  real3 d = vec3(in[RAY_D * LANES], in[(RAY_D + 1) * LANES], in[(RAY_D + 2) * LANES]);
  real t_min = in[RAY_T_MIN * LANES], t_max = in[RAY_T_MAX * LANES];
  Ray ray = ray_make(o, d, t_min, t_max, departed[DEPARTED_ID * LANES]);
  Surface s = surface_at(scene, &ray, &hit, LANES);
  out[HIT_T * LANES] = ray_given_t(&ray, hit.t, t_min, t_max);
  out[HIT_U * LANES] = s.u;
  out[HIT_V * LANES] = s.v;
  out[HIT_NORMAL * LANES] = s.normal.x;
  out[(HIT_NORMAL + 1) * LANES] = s.normal.y;
  out[(HIT_NORMAL + 2) * LANES] = s.normal.z;
  ids[HIT_INSTANCE * LANES] = s.instance;
  ids[HIT_SHAPE * LANES] = s.shape;
  ids[HIT_PRIMITIVE * LANES] = s.primitive;
}
