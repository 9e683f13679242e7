// SPDX-License-Identifier: MIT
// The records of all materials: how LANES points scatter light, and the directions that are drawn there. Directions are
// unit vectors, point away from the surface and are given in its frame, whose z is the normal. One width; no guard.
#include "materials/active_bsdfs.h"
#include "materials/parameter_lanes.h"
#include "materials/rows_lanes.h"

typedef struct {
  intw kind;            ///< MATERIAL_...
  Frame_w frame;        ///< z the shading normal; of a twosided material, that on the side of wo.
  real3w wo;            ///< Where the light goes to; under a coat below it.
  real3w out;           ///< wo in the world, as the frame has not rounded it.
  realw p[BSDF_REALS];  ///< The material's parameters at the point, from constants or textures.
  Relief_w relief;      ///< Kept only with RELIEF.
  Coat_w coat;          ///< Kept only with COAT.
  maskw reflects;       ///< Panes that do not let this path pass (media/panes_lanes.h). Kept only with PANE.
} Bsdf_w;

typedef struct {
  real3w wi;      ///< Where the light comes from.
  real3w weight;  ///< f times |cos| over the density; black: no direction was drawn.
  realw density;  ///< Per solid angle; of a delta lobe the chance that it was drawn.
  realw eta;      ///< Index of refraction on the side of wi over that on the side of wo.
  intw lobe;      ///< LOBE_..., a side and a spread: the one that was drawn.
} BsdfSample_w;

FN real3w black_w(void) {
  realw zero = splat_w(R(0.0));
  return vec3_w(zero, zero, zero);
}

/// Three of the parameters.
FN real3w bsdf_color_w(const Bsdf_w* b, int first) { return vec3_w(b->p[first], b->p[first + 1], b->p[first + 2]); }

FN void put_bsdf_color_w(Bsdf_w* b, maskw which, int first, real3w value) {
  b->p[first] = sel_w(which, value.x, b->p[first]);
  b->p[first + 1] = sel_w(which, value.y, b->p[first + 1]);
  b->p[first + 2] = sel_w(which, value.z, b->p[first + 2]);
}

/// Lanes that drew a lobe of that side or spread.
FN maskw is_lobe_w(const BsdfSample_w* s, int lobes) { return nonzero_w(s->lobe & splat_int_w(lobes)); }

/// No direction.
FN BsdfSample_w no_way_w(const Bsdf_w* b) {
  BsdfSample_w s;
  s.wi = b->wo;
  s.weight = black_w();
  s.density = splat_w(R(0.0));
  s.eta = splat_w(R(1.0));
  s.lobe = splat_int_w(0);
  return s;
}
