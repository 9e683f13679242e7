// SPDX-License-Identifier: MIT
// The materials of surfaces, and dispatch over the active materials. One width; no guard.
#include "materials/bsdf_lanes.h"
#include "materials/all_lanes.h"

/// Lanes of that kind.
FN maskw is_material_w(const Bsdf_w* b, int kind) {
  return ~nonzero_w(b->kind - splat_int_w(ONLY_MATERIAL ? 0 : kind));
}

/// out: where the light goes to, unit, in the world.
FN Bsdf_w bsdf_at_w(const Scene* scene, const Surfaces_w* s, const MaterialRows_w* at, real3w out) {
  GLOBAL const int* index = scene->index;
  Bsdf_w b;
  b.kind = splat_int_w(ONLY_MATERIAL ? 0 : -1);
  for (int i = 0; i < BSDF_REALS; ++i) b.p[i] = splat_w(R(0.0));
  maskw has_along = none_w();
  TexturePlace_w place = texture_place_w(scene, s);
  (void)place;  // A scene without materials.
  maskw which = at_surfaces_w(s);
  for (uint lanes = bits_w(which); lanes != 0u;) {
    int row;
    maskw is_one = next_alike_w(at->rows, which, &lanes, &row);
    int kind = ONLY_MATERIAL ? 0 : index[row + MATERIAL_KIND];
    if (!ONLY_MATERIAL) b.kind = sel_int_w(is_one, splat_int_w(kind), b.kind);
    if (HAS_TANGENT && index[row + MATERIAL_ALONG] != 0) has_along = has_along | is_one;
#define MATERIAL(name, reals, lobes) \
  if (ONLY_MATERIAL || kind == MATERIAL_##name) name##_load_w(scene, &place, row, is_one, &b);
#include "materials/materials.def"
#undef MATERIAL
  }
  Frame_w frame = frame_around_w(at->normal);
  if (HAS_TANGENT) {
    // Twosided materials look from behind as from the front: x and y stay those of the front.
    Frame_w turned = frame_along_w(s->shading, s->along);
    frame.x = sel3_w(has_along, turned.x, frame.x);
    frame.y = sel3_w(has_along, turned.y, frame.y);
  }
  if (HAS_RELIEF) {
    frame.x = sel3_w(at->relief.which, at->relief.frame.x, frame.x);
    frame.y = sel3_w(at->relief.which, at->relief.frame.y, frame.y);
  }
  b.frame = frame;
  b.wo = to_frame_w(&frame, out);
  b.out = out;
  if (HAS_RELIEF) b.relief = at->relief;
  if (HAS_PANE) b.reflects = none_w();
  if (HAS_COAT) {
    b.coat = at->coat;
    coat_view_w(&b.coat, &b.wo);
  }
  return b;
}

/// f times |cos| for light from wi (unit, in the world), without delta lobes. density: the density with which
/// bsdf_sample draws wi.
FN real3w bsdf_eval_w(const Bsdf_w* b, real3w wi, PRIVATE realw* density) {
  real3w in_frame = to_frame_w(&b->frame, wi), value = black_w(), below = in_frame;
  *density = splat_w(R(0.0));
  CoatWay_w in;
  if (HAS_COAT) {
    in = coat_way_w(&b->coat, in_frame);
    below = sel3_w(b->coat.which, in.way, in_frame);
  }
  (void)below;
#define MATERIAL(name, reals, lobes)                  \
  {                                                   \
    maskw is_one = is_material_w(b, MATERIAL_##name); \
    if (ONLY_MATERIAL || any_w(is_one)) {             \
      realw drawn;                                    \
      real3w share = name##_eval_w(b, below, &drawn); \
      *density = sel_w(is_one, drawn, *density);      \
      value = sel3_w(is_one, share, value);           \
    }                                                 \
  }
#include "materials/materials.def"
#undef MATERIAL
  if (HAS_COAT) {
    realw nested = in.squeezed * (splat_w(R(1.0)) - coat_chance_w(&b->coat)), none = splat_w(R(0.0));
    real3w share = scale3_w(in.squeezed, coat_share_w(&b->coat, in.let_in, in.cosine));
    *density = sel_w(b->coat.which, sel_w(lt_w(none, in.let_in), nested * *density, none), *density);
    value = sel3_w(b->coat.which, mul3_w(share, value), value);
  }
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
  realw above = HAS_COAT ? sel_w(b->coat.which, b->coat.wo.z, b->wo.z) : b->wo.z;
  realw along = s->wi.z - straight * above;
  return normalize3_w(fma3_w(along, b->frame.z, scale3_w(straight, b->out)));
}

/// The number with which what is below a coat draws its lobe, in the lanes that have one: what the chance of the coat's
/// own mirror leaves, spread evenly again.
FN realw below_number_w(const Bsdf_w* b, int lobes, realw number) {
  if ((lobes & (LOBE_DIFFUSE | LOBE_GLOSSY)) == 0) return number;
  realw one = splat_w(R(1.0)), chance = coat_chance_w(&b->coat), rest = one - chance, left = number - chance;
  maskw is_below = b->coat.which & lt_w(splat_w(R(0.0)), left);
  // The quotient may round up to 1; the last number below it (tests/physics/test_coats.cpp).
  return sel_w(is_below, min_w(left / rest, splat_w(R(1.0) - real_roundoff())), number);
}

/// What the material below a coat has drawn, as it leaves the coat; or the coat's own mirror, by number. Without spread
/// lobes both, since they mirror to the same place.
INLINE_FN BsdfSample_w leave_coat_w(const Bsdf_w* b, int lobes, realw number, BsdfSample_w s) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), eta = b->coat.eta;
  int are_both = (lobes & (LOBE_DIFFUSE | LOBE_GLOSSY)) == 0, has_mirror = (lobes & LOBE_REFLECT) != 0;
  real3w mirrored = vec3_w(-b->coat.wo.x, -b->coat.wo.y, b->coat.wo.z);
  maskw is_delta = is_lobe_w(&s, LOBE_DELTA), is_any = b->coat.which & lt_w(zero, max3_w(s.weight));
  Fresnel_w f = fresnel_w(min_w(abs_w(s.wi.z), one), one / eta);
  real3w outside = vec3_w(eta * s.wi.x, eta * s.wi.y, sel_w(lt_w(s.wi.z, zero), -f.cosine, f.cosine));
  s.wi = sel3_w(b->coat.which, sel3_w(is_delta, mirrored, outside), s.wi);
  CoatWay_w in = coat_way_w(&b->coat, s.wi);
  real3w share = coat_share_w(&b->coat, in.let_in, in.cosine);
  maskw leaves = is_any & lt_w(zero, in.let_in) & lt_w(f.reflectance, one);
  realw chance = are_both ? zero : coat_chance_w(&b->coat), rest = one - chance;
  real3w weight = scale3_w(one / sel_w(lt_w(zero, rest), rest, one), mul3_w(share, s.weight));
  s.weight = sel3_w(b->coat.which, sel3_w(leaves, weight, black_w()), s.weight);
  realw density = rest * s.density;
  s.density = sel_w(b->coat.which, sel_w(is_delta, density, in.squeezed * density), s.density);
  if ((lobes & LOBE_DELTA) == 0 || !has_mirror) return s;
  maskw is_mirror = b->coat.which & (are_both ? ~none_w() : lt_w(number, chance));
  real3w own = scale3_w((one - b->coat.let_out) / sel_w(is_mirror & lt_w(zero, chance), chance, one), b->coat.specular);
  if (are_both) own = add3_w(own, s.weight);
  s.wi = sel3_w(is_mirror, mirrored, s.wi);
  s.weight = sel3_w(is_mirror, own, s.weight);
  s.density = sel_w(is_mirror, are_both ? one : chance, s.density);
  s.eta = sel_w(is_mirror, one, s.eta);
  s.lobe = sel_int_w(is_mirror, splat_int_w(LOBE_DELTA | LOBE_REFLECT), s.lobe);
  return s;
}

/// Draws a direction in one of `lobes`, by number, u and v; wi is returned in the world.
FN BsdfSample_w bsdf_sample_w(const Bsdf_w* b, int lobes, realw number, realw u, realw v) {
  BsdfSample_w s = no_way_w(b);
  realw own_number = number;
  if (HAS_COAT) number = below_number_w(b, lobes, number);
  (void)lobes;
  (void)number;
  (void)own_number;
  (void)u;
  (void)v;
#define MATERIAL(name, reals, its_lobes)                                                  \
  if (((its_lobes)&LOBE_SIDES & lobes) != 0 && ((its_lobes)&LOBE_SPREADS & lobes) != 0) { \
    maskw is_one = is_material_w(b, MATERIAL_##name);                                     \
    if (ONLY_MATERIAL || any_w(is_one)) {                                                 \
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
  if (HAS_COAT) s = leave_coat_w(b, lobes, own_number, s);
  real3w wi = from_frame_w(&b->frame, s.wi);
  if (HAS_DELTA_LOBES) wi = sel3_w(is_lobe_w(&s, LOBE_DELTA), delta_way_w(b, &s), wi);
  if (HAS_RELIEF) s.weight = scale3_w(relief_share_w(&b->relief, wi, s.wi.z), s.weight);
  s.wi = wi;
  return s;
}
