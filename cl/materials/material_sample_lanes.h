// SPDX-License-Identifier: MIT
// Ways on from surfaces, in their frames. One width; no guard.

typedef struct {
  real3w wi;      ///< Unit.
  real3w weight;  ///< f times |cos| over the density; black: the path ends.
  realw density;  ///< Per solid angle; 0: of all directions only this one reflects (a mirror), no light could be drawn.
} LANED(MaterialSample);

FN real3w LANED(black)(void) {
  realw zero = splat_w(R(0.0));
  return vec3_w(zero, zero, zero);
}
