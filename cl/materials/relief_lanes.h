// SPDX-License-Identifier: MIT
// Normals that a texture bends: by a map of normals, or by the slopes of a map of heights (J. Blinn, "Simulation of
// Wrinkled Surfaces", SIGGRAPH 1978). As Mitsuba's adapters: what the bent normal would let through the surface is
// black, and so is a view from different sides of the two normals, a bent normal that faces away from the view is
// turned about the surface's (V. Schuessler and others, "Microfacet-based Normal Mapping for Robust Monte Carlo Path
// Tracing", SIGGRAPH Asia 2017), and shallow light fades as on a surface of microfacets (A. Estevez, P. Lecocq, C.
// Stein, "A Microfacet-Based Shadowing Function to Solve the Bump Terminator Problem", Ray Tracing Gems, 2019). One
// width; no guard.

/// Slots of a relief's row: the map; whether invalid normals are turned, whether shallow light fades (1, else 0; of
/// heights 2 more), and the length of heights.
enum { RELIEF_MAP_w = 0, RELIEF_OPTIONS_w = 1 };

/// A frame that a relief has bent, in the world.
typedef struct {
  maskw which;    ///< Lanes that have one.
  Frame_w frame;  ///< Of the surface elsewhere, with z where the normal is. x, y: as from the front.
  real3w base;    ///< The normal before.
  realw fading;   ///< alpha^2 of the microfacets that fade shallow light; 0: it does not fade.
  maskw is_seen;  ///< Lanes that are seen from the same side of both normals.
} Relief_w;

/// Relative to the surface's frame, of any length: a normal that a texture holds.
FN real3w mapped_normal_w(real3w texel) {
  realw two = splat_w(R(2.0)), one = splat_w(R(1.0));
  return vec3_w(fma_w(two, texel.x, -one), fma_w(two, texel.y, -one), fma_w(two, texel.z, -one));
}

/// The normal of the surface moved by heights, whose gradient on the surface is slope.x grad_u + slope.y grad_v. x, y:
/// the surface's frame.
FN real3w raised_normal_w(const Surfaces_w* s, const Frame_w* f, Real2_w slope) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0));
  real3w rise = fma3_w(slope.x, s->grad_u, scale3_w(slope.y, s->grad_v));
  // Onto the plane at right angles to the shading normal, along the geometric one.
  realw lean = dot3_w(s->normal, s->shading);
  realw off = dot3_w(rise, s->shading) / sel_w(lt_w(zero, abs_w(lean)), lean, one);
  rise = fma3_w(-off, s->normal, rise);
  // Raised beyond the geometric normal's plane: vertex normals may lie on either side of it.
  maskw is_turned = lt_w(lean * (lean - dot3_w(s->normal, rise)), zero);
  real3w n = vec3_w(-dot3_w(rise, f->x), -dot3_w(rise, f->y), one);
  return sel3_w(is_turned, negate3_w(n), n);
}

/// Bends the normal of the lanes of `which`, whose rows are a relief's.
FN void bend_w(const Scene* scene, const Surfaces_w* s, maskw which, intw rows, real3w out, Relief_w* r) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), two = splat_w(R(2.0));
  real3w options = parameter_at_w(scene, s, which, rows, RELIEF_OPTIONS_w);
  maskw has_heights = which & le_w(two, options.y), fades = lt_w(sel_w(has_heights, two, zero), options.y);
  real3w n = mapped_normal_w(parameter_at_w(scene, s, which & ~has_heights, rows, RELIEF_MAP_w));
  if (any_w(has_heights)) {
    // Without a texture heights are constant.
    Real2_w slope;
    slope.x = slope.y = zero;
    if (TEXTURE_COUNT > 0) {
      intw slot = gather_int_w(scene->index + MATERIAL_SLOTS + RELIEF_MAP_w, rows);
      maskw is_texture = has_heights & s->hit & lt_int_w(slot, splat_int_w(0));
      slope = texture_slopes_w(scene, s, is_texture, ~slot);
      slope.x = slope.x * options.z;
      slope.y = slope.y * options.z;
    }
    n = sel3_w(has_heights, raised_normal_w(s, &r->frame, slope), n);
  }
  real3w view = to_frame_w(&r->frame, out);
  maskw is_invalid = lt_w(zero, options.x) & le_w(view.z * dot3_w(view, n), zero);
  n = sel3_w(is_invalid, vec3_w(-n.x, -n.y, n.z), n);
  maskw has_length = lt_w(zero, max3_w(abs3_w(n))) & finite_w(n.x) & finite_w(n.y) & finite_w(n.z);
  n = normalize3_w(sel3_w(has_length, n, vec3_w(zero, zero, one)));
  // x as far along the surface's as the normal lets it.
  realw q = sqrt_w(fma_w(n.y, n.y, n.z * n.z));
  maskw is_upright = lt_w(zero, q);
  realw divisor = sel_w(is_upright, q, one);
  real3w x = vec3_w(q, -n.x * n.y / divisor, -n.x * n.z / divisor), y = vec3_w(zero, n.z / divisor, -n.y / divisor);
  x = sel3_w(is_upright, x, vec3_w(zero, one, zero));
  y = sel3_w(is_upright, y, vec3_w(zero, zero, n.x));
  realw across2 = fma_w(n.x, n.x, n.y * n.y), along2 = n.z * n.z, eighth = splat_w(R(0.125)) * across2;
  realw fading = sel_w(lt_w(eighth, along2), eighth / sel_w(lt_w(zero, along2), along2, one), one);
  Frame_w bent;
  bent.x = from_frame_w(&r->frame, x);
  bent.y = from_frame_w(&r->frame, y);
  bent.z = normalize3_w(from_frame_w(&r->frame, n));
  r->base = sel3_w(which, r->frame.z, r->base);
  r->fading = sel_w(which, sel_w(fades, fading, zero), r->fading);
  r->frame.x = sel3_w(which, bent.x, r->frame.x);
  r->frame.y = sel3_w(which, bent.y, r->frame.y);
  r->frame.z = sel3_w(which, bent.z, r->frame.z);
  r->is_seen = r->is_seen & (~which | lt_w(zero, view.z * dot3_w(view, n)));
  r->which = r->which | which;
}

/// The share that is left of light from wi, in the world; cosine: of wi and the bent normal.
FN realw relief_share_w(const Relief_w* r, real3w wi, realw cosine) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), two = splat_w(R(2.0)), base = dot3_w(wi, r->base);
  realw c = abs_w(base), sine2 = (one - c) * (one + c);
  realw root = sqrt_w(fma_w(r->fading, sel_w(lt_w(zero, sine2), sine2, zero), c * c));
  maskw is_seen = r->is_seen & lt_w(zero, base * cosine);
  realw left = sel_w(lt_w(zero, r->fading), two * c / sel_w(is_seen, c + root, one), one);
  return sel_w(r->which, sel_w(is_seen, left, zero), one);
}
