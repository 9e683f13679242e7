// SPDX-License-Identifier: MIT
// Materials for paths that come from a light. They carry flux, not radiance, so refraction does not scale it by the
// square of the index; and shading normals make materials asymmetric: a direction's share is multiplied by |in.ns|
// |on.ng| / (|in.ng| |on.ns|) (E. Veach, "Robust Monte Carlo Methods for Light Transport Simulation", 1997, sections
// 5.2 and 5.3). One width; no guard.

/// in, on: unit; ns: the normal that the material has been evaluated with. 1 to the bit where the normals are equal.
FN realw normals_share_w(const Surfaces_w* s, real3w ns, real3w in, real3w on) {
  realw zero = splat_w(R(0.0)), above = abs_w(dot3_w(in, ns)) * abs_w(dot3_w(on, s->normal));
  realw below = abs_w(dot3_w(in, s->normal)) * abs_w(dot3_w(on, ns));
  maskw is_sound = lt_w(zero, below);
  return sel_w(is_sound, above / sel_w(is_sound, below, splat_w(R(1.0))), zero);
}

/// f |in.ns| |on.ng| / |in.ng| for light from `in` to `on`, without delta lobes: the material as a path from the camera
/// would evaluate it, so that nothing of it need be symmetric. opacity: of masks, in programs with MASK.
FN real3w adjoint_share_w(const Scene* scene, const Paths_w* path, const Surfaces_w* s, maskw which, real3w in,
                          real3w on, PRIVATE realw* opacity) {
  realw zero = splat_w(R(0.0)), number = zero, density;
  if (HAS_BLEND) number = random_between_w(met_number_w(scene, path, USE_BLEND));
  MaterialRows_w at = rows_at_w(scene, s, which, on, number);
  *opacity = at.opacity;
  Bsdf_w b = bsdf_at_w(scene, s, &at, on);
  if (HAS_PRIORITY) {
    Crossing_w crossing = crossing_of_w(scene, &path->within, s, &at, which, &b);
    which = which & ~(crossing.which & ~crossing.is_real);
  }
  real3w reflected = bsdf_eval_w(&b, in, &density);
  realw below = abs_w(dot3_w(in, s->normal)), above = abs_w(dot3_w(on, s->normal));
  maskw is_sound = which & lt_w(zero, below);
  realw share = above / sel_w(is_sound, below, splat_w(R(1.0)));
  return sel3_w(is_sound, scale3_w(share, reflected), black_w());
}

/// Lanes whose material scatters otherwise where the light comes the other way. A relief bends the normal by where
/// light goes to, and fades by where it comes from.
FN maskw is_one_way_w(const Bsdf_w* b) {
  maskw found = none_w();
  if (HAS_RELIEF) found = b->relief.which;
#define MATERIAL(name, reals, lobes) \
  if (((lobes)&LOBE_ONE_WAY) != 0) found = found | is_material_w(b, MATERIAL_##name);
#include "materials/materials.def"
#undef MATERIAL
  return found;
}

/// way: drawn as if light went to where the path comes from.
FN void make_adjoint_w(const Scene* scene, const Paths_w* path, const Bsdf_w* b, const Surfaces_w* s, maskw which,
                       BsdfSample_w* way) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), share = normals_share_w(s, b->frame.z, b->out, way->wi);
  if (HAS_TRANSMISSION) share = share * (way->eta * way->eta);
  real3w weight = scale3_w(share, way->weight);
  maskw is_delta = is_lobe_w(way, LOBE_DELTA);
  if (HAS_RELIEF) {
    // Rays through glass of equal indices have their direction as it came, of any length.
    real3w to = unit3_w(way->wi);
    realw there = relief_share_w(&b->relief, to, dot3_w(to, b->frame.z));
    realw back = relief_share_w(&b->relief, b->out, dot3_w(b->out, b->frame.z));
    maskw is_faded = is_delta & lt_w(zero, there);
    weight = sel3_w(is_faded, scale3_w(back / sel_w(is_faded, there, one), weight), weight);
  }
  maskw is_one_way = which & is_one_way_w(b) & ~is_delta & lt_w(zero, way->density);
  if (any_w(is_one_way)) {
    realw opacity;
    real3w exact = adjoint_share_w(scene, path, s, is_one_way, b->out, way->wi, &opacity);
    weight = sel3_w(is_one_way, scale3_w(one / sel_w(is_one_way, way->density, one), exact), weight);
  }
  way->weight = weight;
  way->eta = one;
}
