// SPDX-License-Identifier: MIT
// Lights at a point whose intensity differs from direction to direction: it is what their own samples have at a point
// in that direction, times the square of the distance. One width; no guard.

/// A point in direction `way`, unit or longer, far enough that the difference has the direction's digits.
FN real3w point_in_way_w(real3w position, real3w way) {
  realw distance = splat_w(R(1.0)) + max3_w(abs3_w(position));
  return fma3_w(distance, way, position);
}

/// Of the sample there, in W/sr.
FN real3w intensity_of_w(const LightSample_w* s) { return scale3_w(dot3_w(s->towards, s->towards), s->radiance); }
