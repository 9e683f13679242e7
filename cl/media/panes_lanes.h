// SPDX-License-Identifier: MIT
// Panes of thin glass, for integrators that look through surfaces: the light that goes straight through them is no
// event (as in Mitsuba's volpath). What a pane reflects is. Under a coat, or with a normal that a texture bends, it is
// a material as any other. One width; no guard.

typedef struct {
  maskw which;    ///< Lanes that are at a pane.
  realw through;  ///< The share of light that goes through, before its colour.
  real3w tint;    ///< Its colour.
} Pane_w;

/// The panes among the lanes of `which`; those within a body of a higher priority are not there, so that all light goes
/// through them. out: unit, in the world.
FN Pane_w pane_at_w(const Scene* scene, const Interfaces_w* within, const Surfaces_w* s, const MaterialRows_w* at,
                    maskw which, real3w out) {
  Pane_w pane;
  pane.which = which;
  if (!ONLY_MATERIAL) {
    intw kind = gather_int_w(scene->index + MATERIAL_KIND, at->rows);
    pane.which = which & ~nonzero_w(kind - splat_int_w(MATERIAL_thindielectric));
  }
  if (HAS_RELIEF) pane.which = pane.which & ~at->relief.which;
  if (HAS_COAT) pane.which = pane.which & ~at->coat.which;
  pane.through = splat_w(R(0.0));
  pane.tint = black_w();
  if (!any_w(pane.which)) return pane;
  realw eta = parameter_at_w(scene, s, pane.which, at->rows, THINDIELECTRIC_ETA_w / 3).x, through;
  pane_reflectance_w(abs_w(dot3_w(out, at->normal)), eta, &through);
  pane.through = sel_w(pane.which, through, pane.through);
  pane.tint = parameter_at_w(scene, s, pane.which, at->rows, THINDIELECTRIC_TRANSMITTANCE_w / 3);
  if (HAS_PRIORITY) {
    Crossing_w c = crossing_at_w(scene, within, s, pane.which, splat_w(R(0.0)));
    maskw unreal = c.which & ~c.is_real;
    realw one = splat_w(R(1.0));
    pane.through = sel_w(unreal, one, pane.through);
    pane.tint = sel3_w(unreal, vec3_w(one, one, one), pane.tint);
  }
  return pane;
}

/// Lanes of `which` that panes let pass. reflects: those that are at a pane and do not pass.
FN maskw passes_panes_w(const Scene* scene, Paths_w* path, const Surfaces_w* s, const MaterialRows_w* at, maskw which,
                        real3w out, PRIVATE maskw* reflects) {
  Pane_w pane = pane_at_w(scene, &path->within, s, at, which, out);
  *reflects = none_w();
  if (!any_w(pane.which)) return pane.which;
  Random4_w numbers = stream_numbers_w(&path->sample, pane.which, &path->draws);
  maskw passes = pane.which & lt_w(random_between_w(numbers.x), pane.through);
  path->throughput = sel3_w(passes, mul3_w(path->throughput, pane.tint), path->throughput);
  *reflects = pane.which & ~passes;
  return passes;
}
