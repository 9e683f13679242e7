// SPDX-License-Identifier: MIT
// Surfaces as light meets them on its way to the camera, and dispatch over the active materials. One width; no guard.
#include "materials/bsdf_lanes.h"
#include "materials/parameter_lanes.h"
#include "materials/all_lanes.h"

/// Lanes of that kind.
FN maskw LANED(is_material)(const LANED(Bsdf) * b, int kind) {
  return ~nonzero_w(b->kind - splat_int_w(MATERIAL_COUNT == 1 ? 0 : kind));
}

/// out: where the light goes to, unit, in the world.
FN LANED(Bsdf) LANED(bsdf_at)(const Scene* scene, const LANED(Surfaces) * s, real3w out) {
  GLOBAL const int* index = scene->index;
  intw rows = LANED(part_entry)(scene, s, PART_MATERIAL) * (int)MATERIAL_INTS + splat_int_w(index[HEADER_MATERIALS]);
  real3w z = s->shading;
  if (HAS_TWOSIDED) {
    maskw is_twosided = nonzero_w(gather_int_w(index + MATERIAL_TWOSIDED, rows));
    z = sel3_w(is_twosided & lt_w(dot3_w(out, z), splat_w(R(0.0))), negate3_w(z), z);
  }
  LANED(Frame) frame = LANED(frame_around)(z);
  intw kind = MATERIAL_COUNT == 1 ? splat_int_w(0) : gather_int_w(index + MATERIAL_KIND, rows);
  LANED(Bsdf) b = {kind, frame, LANED(to_frame)(&frame, out), out, {splat_w(R(0.0))}};
#define MATERIAL(name, reals, lobes)                                                          \
  {                                                                                           \
    maskw is_one = LANED(is_material)(&b, MATERIAL_##name);                                   \
    if (MATERIAL_COUNT == 1 || any_w(is_one)) LANED(name##_load)(scene, s, rows, is_one, &b); \
  }
#include "materials/materials.def"
#undef MATERIAL
  return b;
}

/// f times |cos| for light from wi, unit, in the world, delta lobes left out; density: how densely bsdf_sample draws
/// wi.
FN real3w LANED(bsdf_eval)(const LANED(Bsdf) * b, real3w wi, PRIVATE realw* density) {
  real3w in_frame = LANED(to_frame)(&b->frame, wi), value = LANED(black)();
  *density = splat_w(R(0.0));
  (void)in_frame;
#define MATERIAL(name, reals, lobes)                          \
  {                                                           \
    maskw is_one = LANED(is_material)(b, MATERIAL_##name);    \
    if (MATERIAL_COUNT == 1 || any_w(is_one)) {               \
      realw drawn;                                            \
      real3w share = LANED(name##_eval)(b, in_frame, &drawn); \
      *density = sel_w(is_one, drawn, *density);              \
      value = sel3_w(is_one, share, value);                   \
    }                                                         \
  }
#include "materials/materials.def"
#undef MATERIAL
  return value;
}

/// The direction of a delta lobe in the world, by its normal alone: the frame's rounding would turn it, and add up
/// where mirrors follow each other. Normalised, so that its length does not drift either.
FN real3w LANED(delta_way)(const LANED(Bsdf) * b, const LANED(BsdfSample) * s) {
  realw one = splat_w(R(1.0)), straight = -one;
  if (HAS_TRANSMISSION) straight = sel_w(LANED(is_lobe)(s, LOBE_TRANSMIT), -one / s->eta, straight);
  realw along = s->wi.z - straight * b->wo.z;
  return normalize3_w(fma3_w(along, b->frame.z, scale3_w(straight, b->out)));
}

/// A way on in one of `lobes`, drawn by number, u and v; wi comes out in the world.
FN LANED(BsdfSample) LANED(bsdf_sample)(const LANED(Bsdf) * b, int lobes, realw number, realw u, realw v) {
  LANED(BsdfSample) s = LANED(no_way)(b);
  (void)lobes;
  (void)number;
  (void)u;
  (void)v;
#define MATERIAL(name, reals, its_lobes)                                                  \
  if (((its_lobes)&LOBE_SIDES & lobes) != 0 && ((its_lobes)&LOBE_SPREADS & lobes) != 0) { \
    maskw is_one = LANED(is_material)(b, MATERIAL_##name);                                \
    if (MATERIAL_COUNT == 1 || any_w(is_one)) {                                           \
      LANED(BsdfSample) drawn = LANED(name##_sample)(b, lobes, number, u, v);             \
      s.wi = sel3_w(is_one, drawn.wi, s.wi);                                              \
      s.weight = sel3_w(is_one, drawn.weight, s.weight);                                  \
      s.density = sel_w(is_one, drawn.density, s.density);                                \
      s.eta = sel_w(is_one, drawn.eta, s.eta);                                            \
      s.lobe = sel_int_w(is_one, drawn.lobe, s.lobe);                                     \
    }                                                                                     \
  }
#include "materials/materials.def"
#undef MATERIAL
  real3w wi = LANED(from_frame)(&b->frame, s.wi);
  if (HAS_DELTA_LOBES) wi = sel3_w(LANED(is_lobe)(&s, LOBE_DELTA), LANED(delta_way)(b, &s), wi);
  s.wi = wi;
  return s;
}
