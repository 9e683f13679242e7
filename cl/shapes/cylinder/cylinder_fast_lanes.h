// SPDX-License-Identifier: MIT
// Rays against open cylinders as in textbooks: b^2 - 4 a c across the axis, in world coordinates.

FN CylinderHits_w cylinder_hits_w(real3w o, real3w d, const Cylinders_w* cylinder, realw t_min, maskw which,
                                  maskw departed) {
  CylinderHits_w hits;
  real3w g = sub3_w(o, cylinder->foot), v = cylinder->axis;
  realw length = cylinder->length, r = cylinder->r, zero = splat_w(R(0.0));
  realw o_along = g.x * v.x + g.y * v.y + g.z * v.z, d_along = d.x * v.x + d.y * v.y + d.z * v.z;
  realw a = d.x * d.x + d.y * d.y + d.z * d.z - d_along * d_along;
  realw b = splat_w(R(2.0)) * (g.x * d.x + g.y * d.y + g.z * d.z - o_along * d_along);
  realw c = g.x * g.x + g.y * g.y + g.z * g.z - o_along * o_along - r * r;
  realw discriminant = b * b - splat_w(R(4.0)) * a * c;
  (void)departed;
  hits.which = which & le_w(zero, discriminant);
  hits.t = zero;
  if (!any_w(hits.which)) return hits;
  realw root = sqrt_w(discriminant), scale = splat_w(R(0.5)) / a;
  realw near = (-b - root) * scale, far = (root - b) * scale;
  realw near_along = o_along + near * d_along;
  maskw near_hit = le_w(t_min, near) & le_w(zero, near_along) & le_w(near_along, length);
  realw t = sel_w(near_hit, near, far);
  realw along = o_along + t * d_along;
  hits.which = hits.which & le_w(zero, along) & le_w(along, length);
  hits.t = t;
  return hits;
}
