// SPDX-License-Identifier: MIT
// Rough surfaces as microfacets: how their normals are distributed, how much of them a direction sees, and the draw of
// one. All in the surface's frame, wo in the upper hemisphere. One width; no guard.

/// Parameters of a material: alpha_u in the first real of a slot, alpha_v in the first of the next one, then the
/// distribution (0 Beckmann, 1 GGX) and whether the visible normals are drawn.
typedef struct {
  realw alpha_u, alpha_v;
  maskw is_ggx, is_visible;
} Microfacets_w;

#include "materials/beckmann_lanes.h"
#include "materials/ggx_lanes.h"

enum { MICROFACETS_SLOTS_w = 3 };

FN void microfacets_load_w(const Scene* scene, const TexturePlace_w* at, int row, maskw which, int slot, Bsdf_w* b,
                           int first) {
  for (int k = 0; k < MICROFACETS_SLOTS_w; ++k) {
    real3w value = parameter_of_w(scene, at, row, slot + k);
    if (k < 2) value.x = luminance_w(value);  // alpha along u and across are numbers.
    put_bsdf_color_w(b, which, first + 3 * k, value);
  }
}

FN Microfacets_w microfacets_of_w(const Bsdf_w* b, int first) {
  Microfacets_w f;
  realw zero = splat_w(R(0.0)), least = splat_w(R(1e-4));  // As Mitsuba; held by tests/physics/test_microfacets.cpp.
  f.alpha_u = max_w(b->p[first], least);
  f.alpha_v = max_w(b->p[first + 3], least);
  f.is_ggx = lt_w(zero, b->p[first + 6]);
  f.is_visible = lt_w(zero, b->p[first + 7]);
  return f;
}

/// Density of microfacets' normals m by solid angle and projected area.
FN realw facets_normals_w(const Microfacets_w* f, real3w m) {
  if (!HAS_GGX) return beckmann_normals_w(f, m);
  if (!HAS_BECKMANN) return ggx_normals_w(f, m);
  return sel_w(f->is_ggx, ggx_normals_w(f, m), beckmann_normals_w(f, m));
}

FN realw facets_across_w(const Microfacets_w* f, real3w v) {
  realw x = f->alpha_u * v.x, y = f->alpha_v * v.y;
  return sqrt_w(fma_w(x, x, y * y));
}

/// The share of microfacets that v sees, over its cosine, as values have it. v: on either side.
FN realw facets_masking_w(const Microfacets_w* f, real3w v) {
  realw across = facets_across_w(f, v), z = abs_w(v.z);
  if (!HAS_GGX) return beckmann_masking_w(z, across);
  if (!HAS_BECKMANN) return ggx_masking_w(z, across);
  return sel_w(f->is_ggx, ggx_masking_w(z, across), beckmann_masking_w(z, across));
}

/// The same as densities have it.
FN realw facets_exact_masking_w(const Microfacets_w* f, real3w v) {
  realw across = facets_across_w(f, v), z = abs_w(v.z);
  if (!HAS_GGX) return beckmann_exact_masking_w(z, across);
  if (!HAS_BECKMANN) return ggx_masking_w(z, across);
  return sel_w(f->is_ggx, ggx_masking_w(z, across), beckmann_exact_masking_w(z, across));
}

/// Density per solid angle with which facets_draw draws m, over the cosine between m and wo.
FN realw facets_density_w(const Microfacets_w* f, real3w wo, real3w m, realw normals, realw cosine) {
  return normals * sel_w(f->is_visible, facets_exact_masking_w(f, wo), m.z / cosine);
}

/// A normal, unit, by u and v within (0, 1).
SELDOM_FN real3w facets_draw_w(const Microfacets_w* f, real3w wo, realw u, realw v) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0));
  real3w stretched = normalize3_w(vec3_w(f->alpha_u * wo.x, f->alpha_v * wo.y, wo.z)), m = stretched;
  maskw is_ggx = HAS_GGX && HAS_BECKMANN ? f->is_ggx : HAS_GGX ? ~none_w() : none_w();
  if (HAS_GGX) m = ggx_visible_normal_w(stretched, u, v);
  if (HAS_BECKMANN && any_w(f->is_visible & ~is_ggx)) {
    realw sine = sqrt_w(fma_w(stretched.x, stretched.x, stretched.y * stretched.y));
    maskw is_upright = le_w(sine, zero);
    realw scale = sel_w(is_upright, one, sine);
    realw x = sel_w(is_upright, one, stretched.x) / scale, y = stretched.y / scale;
    Real2_w slopes = beckmann_visible_slopes_w(sine, stretched.z, u, v);
    real3w by_slopes = vec3_w(fma_w(-x, slopes.x, y * slopes.y), -fma_w(y, slopes.x, x * slopes.y), one);
    m = sel3_w(is_ggx, m, by_slopes);
  }
  if (any_w(~f->is_visible)) {
    realw steepness = zero;
    if (HAS_GGX) steepness = ggx_steepness_w(u);
    if (HAS_BECKMANN) steepness = sel_w(is_ggx, steepness, beckmann_steepness_w(u));
    SinCos_w turned = sincos_turns_w(v);
    realw slope = sqrt_w(steepness);
    m = sel3_w(f->is_visible, m, vec3_w(slope * turned.cosine, slope * turned.sine, one));
  }
  return normalize3_w(vec3_w(f->alpha_u * m.x, f->alpha_v * m.y, m.z));
}

/// a + b of unit vectors in the upper hemisphere, which their mirror's normal is along. Across their plane the sum is
/// accurate to the roundoff. Where both are shallow and opposite, it is nearly 0 along the surface and the sum would
/// cancel: there its component along a - b follows from a.z and b.z, because (a + b)(a - b) = 0.
FN real3w bisector_w(real3w a, real3w b) {
  realw one = splat_w(R(1.0)), x = a.x - b.x, y = a.y - b.y, apart2 = fma_w(x, x, y * y);
  real3w sum = add3_w(a, b);
  maskw is_shallow = lt_w(one, apart2);
  realw wanted = (b.z - a.z) * (b.z + a.z), there = fma_w(sum.x, x, sum.y * y);
  realw more = sel_w(is_shallow, wanted - there, splat_w(R(0.0))) / sel_w(is_shallow, apart2, one);
  return vec3_w(fma_w(more, x, sum.x), fma_w(more, y, sum.y), sum.z);
}

/// Reflection at a normal m.
FN real3w facets_mirror_w(real3w wo, real3w m, realw cosine) {
  return normalize3_w(fma3_w(cosine + cosine, m, negate3_w(wo)));
}
