// SPDX-License-Identifier: MIT
// Barycentrics of flat polygons, one primitive: the scalar twin of edge_lanes.h, the same operations.
#ifndef STRAHL_SHAPES_EDGES_H
#define STRAHL_SHAPES_EDGES_H

#include "hits/surface.h"
#include "shapes/polygon/corners.h"

typedef struct {
  real x, y;
} Sheared;

FN Sheared shear_point(const Ray* ray, real3 p) {
  Sheared s;
  real z = component(p, ray->kz) - component(ray->o, ray->kz);
  s.x = real_fma(-ray->shear_x, z, component(p, ray->kx) - component(ray->o, ray->kx));
  s.y = real_fma(-ray->shear_y, z, component(p, ray->ky) - component(ray->o, ray->ky));
  return s;
}

FN real edge_of(Sheared a, Sheared b) { return difference_of_products(b.x, a.y, b.y, a.x); }

/// Clamped into [0, 1]; weights of p1 and p2 from the edge functions that decided the hit.
FN void barycentrics(const Ray* ray, real3 p0, real3 p1, real3 p2, real* u, real* v) {
  Sheared a = shear_point(ray, p0), b = shear_point(ray, p1), c = shear_point(ray, p2);
  real ea = edge_of(b, c), eb = edge_of(c, a), ec = edge_of(a, b);
  real sum = ea + eb + ec;
  real wu = eb / sum, wv = ec / sum;
  *u = wu > R(0.0) ? (wu < R(1.0) ? wu : R(1.0)) : R(0.0);
  *v = wv > R(0.0) ? (wv < R(1.0) ? wv : R(1.0)) : R(0.0);
}

#endif
