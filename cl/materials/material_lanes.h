// SPDX-License-Identifier: MIT
// The materials of surfaces, and dispatch over the active materials. One width; no guard.
#include "materials/bsdf_lanes.h"
#include "materials/all_lanes.h"

/// Lanes of that kind.
FN maskw is_material_w(const Bsdf_w* b, int kind) {
  return ~nonzero_w(b->kind - splat_int_w(MATERIAL_COUNT == 1 ? 0 : kind));
}

/// out: where the light goes to, unit, in the world.
FN Bsdf_w bsdf_at_w(const Scene* scene, const Surfaces_w* s, const MaterialRows_w* at, real3w out) {
  GLOBAL const int* index = scene->index;
  intw rows = at->rows;
  Frame_w frame = frame_around_w(at->normal);
  if (HAS_TANGENT) {
    // Twosided materials look from behind as from the front: x and y stay those of the front.
    maskw has_along = nonzero_w(gather_int_w(index + MATERIAL_ALONG, rows));
    Frame_w turned = frame_along_w(s->shading, s->along);
    frame.x = sel3_w(has_along, turned.x, frame.x);
    frame.y = sel3_w(has_along, turned.y, frame.y);
  }
  intw kind = MATERIAL_COUNT == 1 ? splat_int_w(0) : gather_int_w(index + MATERIAL_KIND, rows);
  if (HAS_RELIEF) {
    frame.x = sel3_w(at->relief.which, at->relief.frame.x, frame.x);
    frame.y = sel3_w(at->relief.which, at->relief.frame.y, frame.y);
  }
  Bsdf_w b;
  b.kind = kind;
  b.frame = frame;
  b.wo = to_frame_w(&frame, out);
  b.out = out;
  for (int i = 0; i < BSDF_REALS; ++i) b.p[i] = splat_w(R(0.0));
  if (HAS_RELIEF) b.relief = at->relief;
#define MATERIAL(name, reals, lobes)                                                     \
  {                                                                                      \
    maskw is_one = is_material_w(&b, MATERIAL_##name);                                   \
    if (MATERIAL_COUNT == 1 || any_w(is_one)) name##_load_w(scene, s, rows, is_one, &b); \
  }
#include "materials/materials.def"
#undef MATERIAL
  return b;
}

/// f times |cos| for light from wi (unit, in the world), without delta lobes. density: the density with which
/// bsdf_sample draws wi.
FN real3w bsdf_eval_w(const Bsdf_w* b, real3w wi, PRIVATE realw* density) {
  real3w in_frame = to_frame_w(&b->frame, wi), value = black_w();
  *density = splat_w(R(0.0));
  (void)in_frame;
#define MATERIAL(name, reals, lobes)                     \
  {                                                      \
    maskw is_one = is_material_w(b, MATERIAL_##name);    \
    if (MATERIAL_COUNT == 1 || any_w(is_one)) {          \
      realw drawn;                                       \
      real3w share = name##_eval_w(b, in_frame, &drawn); \
      *density = sel_w(is_one, drawn, *density);         \
      value = sel3_w(is_one, share, value);              \
    }                                                    \
  }
#include "materials/materials.def"
#undef MATERIAL
  if (HAS_RELIEF) {
    realw share = relief_share_w(&b->relief, wi, in_frame.z);
    *density = sel_w(lt_w(splat_w(R(0.0)), share), *density, splat_w(R(0.0)));
    value = scale3_w(share, value);
  }
  return value;
}

/// The direction of a delta lobe in the world, computed from the normal alone: the frame's rounding would turn the
/// direction, and the error would grow from mirror to mirror. Normalised, so that the length does not drift either.
FN real3w delta_way_w(const Bsdf_w* b, const BsdfSample_w* s) {
  realw one = splat_w(R(1.0)), straight = -one;
  if (HAS_TRANSMISSION) straight = sel_w(is_lobe_w(s, LOBE_TRANSMIT), -one / s->eta, straight);
  realw along = s->wi.z - straight * b->wo.z;
  return normalize3_w(fma3_w(along, b->frame.z, scale3_w(straight, b->out)));
}

/// Draws a direction in one of `lobes`, by number, u and v; wi is returned in the world.
FN BsdfSample_w bsdf_sample_w(const Bsdf_w* b, int lobes, realw number, realw u, realw v) {
  BsdfSample_w s = no_way_w(b);
  (void)lobes;
  (void)number;
  (void)u;
  (void)v;
#define MATERIAL(name, reals, its_lobes)                                                  \
  if (((its_lobes)&LOBE_SIDES & lobes) != 0 && ((its_lobes)&LOBE_SPREADS & lobes) != 0) { \
    maskw is_one = is_material_w(b, MATERIAL_##name);                                     \
    if (MATERIAL_COUNT == 1 || any_w(is_one)) {                                           \
      BsdfSample_w drawn = name##_sample_w(b, lobes, number, u, v);                       \
      s.wi = sel3_w(is_one, drawn.wi, s.wi);                                              \
      s.weight = sel3_w(is_one, drawn.weight, s.weight);                                  \
      s.density = sel_w(is_one, drawn.density, s.density);                                \
      s.eta = sel_w(is_one, drawn.eta, s.eta);                                            \
      s.lobe = sel_int_w(is_one, drawn.lobe, s.lobe);                                     \
    }                                                                                     \
  }
#include "materials/materials.def"
#undef MATERIAL
  real3w wi = from_frame_w(&b->frame, s.wi);
  if (HAS_DELTA_LOBES) wi = sel3_w(is_lobe_w(&s, LOBE_DELTA), delta_way_w(b, &s), wi);
  if (HAS_RELIEF) s.weight = scale3_w(relief_share_w(&b->relief, wi, s.wi.z), s.weight);
  s.wi = wi;
  return s;
}
