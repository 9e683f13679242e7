// SPDX-License-Identifier: MIT
// A smooth layer of glass over a material, as Mitsuba 0.x's plugin "coating" (W. Jakob, Mitsuba 0.6 documentation,
// section 8.2; A. Weidlich, A. Wilkie, "Arbitrarily Layered Micro-Facet Surfaces", GRAPHITE 2007): its surface mirrors
// a share of the light, and the rest meets the material below on refracted ways, is absorbed along both of them, and
// leaves. Light that the layer throws back from within is lost. It covers both sides alike. As a relief it is a row
// with one row inside it, and the material below knows nothing of it. One width; no guard.
#include "math/exp_log_lanes.h"
#include "math/fresnel_lanes.h"

/// Slots of its row: what it mirrors; absorption per unit of length; index of refraction over that outside, weight of
/// specular draws, thickness.
enum { COAT_SPECULAR_w = 0, COAT_ABSORPTION_w = 1, COAT_GLASS_w = 2 };

typedef struct {
  maskw which;         ///< Lanes that have one.
  real3w specular;     ///< What it mirrors.
  real3w depth;        ///< Optical depth straight through.
  realw eta, weight;   ///< Of refraction; of specular draws.
  real3w wo;           ///< Where the light goes to, above it, in the frame.
  realw let_out, out;  ///< The share that is not mirrored there; the cosine below.
} Coat_w;

/// A way below the layer.
typedef struct {
  real3w way;      ///< Unit, on the same side.
  realw let_in;    ///< The share that is not mirrored; 0: no way below.
  realw cosine;    ///< Of the way below, without its sign.
  realw squeezed;  ///< Solid angle below over that above.
} CoatWay_w;

FN void coat_none_w(Coat_w* c) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0));
  c->which = none_w();
  c->specular = c->depth = c->wo = vec3_w(zero, zero, zero);
  c->eta = c->out = one;
  c->weight = c->let_out = zero;
}

FN void coat_load_w(const Scene* scene, const Surfaces_w* s, maskw which, intw rows, Coat_w* c) {
  real3w specular = parameter_at_w(scene, s, which, rows, COAT_SPECULAR_w);
  real3w absorption = parameter_at_w(scene, s, which, rows, COAT_ABSORPTION_w);
  real3w glass = parameter_at_w(scene, s, which, rows, COAT_GLASS_w);
  c->which = c->which | which;
  c->specular = sel3_w(which, specular, c->specular);
  c->depth = sel3_w(which, scale3_w(glass.z, absorption), c->depth);
  c->eta = sel_w(which, glass.x, c->eta);
  c->weight = sel_w(which, glass.y, c->weight);
}

/// w: above the layer, in the frame.
FN CoatWay_w coat_way_w(const Coat_w* c, real3w w) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), above = min_w(abs_w(w.z), one), inverse = one / c->eta;
  Fresnel_w f = fresnel_w(above, c->eta);
  realw below = f.cosine;
  CoatWay_w in;
  maskw is_there = lt_w(zero, below) & lt_w(zero, above);
  in.cosine = sel_w(is_there, below, one);
  in.let_in = sel_w(is_there, f.transmittance, zero);
  in.squeezed = inverse * inverse * (above / in.cosine);
  in.way = vec3_w(inverse * w.x, inverse * w.y, sel_w(lt_w(w.z, zero), -in.cosine, in.cosine));
  return in;
}

/// Takes the view below the layer, in the lanes that have one. wo: in the frame, on entry above.
FN void coat_view_w(Coat_w* c, real3w* wo) {
  c->wo = *wo;
  CoatWay_w out = coat_way_w(c, *wo);
  c->let_out = out.let_in;
  c->out = out.cosine;
  *wo = sel3_w(c->which, out.way, *wo);
}

/// What is left of light between a way below and the view.
FN real3w coat_share_w(const Coat_w* c, realw let_in, realw cosine) {
  realw one = splat_w(R(1.0)), slant = one / cosine + one / c->out;
  real3w left =
      vec3_w(exp_minus_w(c->depth.x * slant), exp_minus_w(c->depth.y * slant), exp_minus_w(c->depth.z * slant));
  return scale3_w(let_in * c->let_out, left);
}

/// The chance that the layer's mirror is drawn, not what is below.
FN realw coat_chance_w(const Coat_w* c) {
  realw one = splat_w(R(1.0)), specular = (one - c->let_out) * c->weight, below = c->let_out * (one - c->weight);
  realw sum = specular + below;
  return sel_w(lt_w(splat_w(R(0.0)), sum), specular / sum, one);
}
