// SPDX-License-Identifier: MIT
// A point on a flat polygon that is large compared with the distance to the point, such as a floor that reaches to the
// horizon. A point interpolated over the corners has an error of the size of their rounding, even if the point is near.
// A point computed as the intersection of ray and plane has an error of the size of the distance's rounding, if the
// plane is known well, as it is for floors and walls along the axes. A running bound (N. Higham, Accuracy and Stability
// of Numerical Algorithms, 2002, section 3.3) says which of the two is nearer.
//
// With e, f the edges, n = e x f computed, w = |e_y f_z| + |e_z f_y| ... and u the roundoff: a component of n is off by
// at most 4 u w, of its unit vector by 9 u w / |n|; products with it add 4 u w / |n|. flat_surfaces_lanes.h has the
// same in lanes, operation by operation. Held by tests/cl/test_near_point.cpp.
#ifndef STRAHL_SHAPES_NEAR_POINT_H
#define STRAHL_SHAPES_NEAR_POINT_H

#include "hits/surface.h"

FN real3 products_size(real3 e, real3 f) {
  return vec3(real_abs(e.y * f.z) + real_abs(e.z * f.y), real_abs(e.z * f.x) + real_abs(e.x * f.z),
              real_abs(e.x * f.y) + real_abs(e.y * f.x));
}

/// For a polygon that is hit, with the corner a and the edges e and f there. s: position, normal and facing are set
/// already. What the traversal found as t is not asked: it may be approximate, and differ from one traversal to
/// another.
FN void take_near_point(const Ray* ray, real3 a, real3 e, real3 f, Surface* s) {
  real size_e = max3(abs3(e)), size_f = max3(abs3(f)), size = size_e > size_f ? size_e : size_f;
  real3 way = sub3(a, ray->o);
  real near_t = dot3(s->normal, way) / s->facing;
  if (!(R(32.0) * real_fma(real_abs(near_t), max3(abs3(ray->d)), max3(abs3(ray->o))) < size)) return;
  real3 sizes = products_size(e, f);
  real3 p = fma3(near_t, ray->d, ray->o);
  real3 n = vec3(e.y * f.z - e.z * f.y, e.z * f.x - e.x * f.z, e.x * f.y - e.y * f.x);
  real across = real_abs(dot3(s->normal, n));
  real rounded = real_fma(real_abs(near_t), dot3(sizes, abs3(ray->d)), dot3(sizes, abs3(way))) / across;
  real off = real_roundoff() * real_fma(R(16.0), rounded, R(2.0) * max3(abs3(p)));
  // As in departure_bound.
  if (!(off < R(1.75) * real_roundoff() * (max3(abs3(s->position)) + size)) || !is_finite3(p)) return;
  s->position = p;
  s->off = off;
}

#endif
