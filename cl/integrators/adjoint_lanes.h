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

/// way: drawn as if light went to where the path comes from.
FN void make_adjoint_w(const Bsdf_w* b, const Surfaces_w* s, BsdfSample_w* way) {
  realw zero = splat_w(R(0.0)), share = normals_share_w(s, b->frame.z, b->out, way->wi);
  if (HAS_TRANSMISSION) share = share * (way->eta * way->eta);
  if (HAS_RELIEF) {
    // Reliefs fade shallow light, which now comes from the other side.
    realw given = relief_share_w(&b->relief, way->wi, dot3_w(b->frame.z, way->wi));
    realw wanted = relief_share_w(&b->relief, b->out, dot3_w(b->frame.z, b->out));
    maskw is_sound = lt_w(zero, given);
    share = sel_w(is_sound, share * wanted / sel_w(is_sound, given, splat_w(R(1.0))), zero);
  }
  way->weight = scale3_w(share, way->weight);
  way->eta = splat_w(R(1.0));
}
