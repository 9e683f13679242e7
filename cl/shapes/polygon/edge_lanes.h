// SPDX-License-Identifier: MIT
// Sheared vertices and edge functions for triangle_lanes.h and parallelogram_lanes.h, one width; no guard.
// S. Woop, C. Benthin, I. Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013, with the sign of every edge
// function made exact by Kahan's difference of products (math/vec3.h), so no fp64 fallback is needed. A vertex is
// sheared by exactly the same operations in every primitive that shares it, so neighbours agree on the sign.
// Where an edge function is exactly 0 the ray counts as shifted by (delta, delta^2), delta -> 0: of the primitives
// around an edge or a vertex exactly one is hit (simulation of simplicity; Edelsbrunner, Muecke, ACM TOG 9(1), 1990).

typedef struct {
  realw x, y, z;  ///< x, y: in the plane across the ray. z: along its largest axis, not yet divided.
} ShearedVertex_w;

/// planes: three planes (x, y, z) of LANES reals.
FN ShearedVertex_w shear_vertex_w(const Ray* ray, GLOBAL const real* planes) {
  ShearedVertex_w v;
  realw x = load_w(planes + ray->kx * LANES) - splat_w(component(ray->o, ray->kx));
  realw y = load_w(planes + ray->ky * LANES) - splat_w(component(ray->o, ray->ky));
  v.z = load_w(planes + ray->kz * LANES) - splat_w(component(ray->o, ray->kz));
  v.x = fma_w(splat_w(-ray->shear_x), v.z, x);
  v.y = fma_w(splat_w(-ray->shear_y), v.z, y);
  return v;
}

/// Twice the signed area of (ray, a, b), exact in sign: b.x a.y - b.y a.x.
FN realw edge_function_w(ShearedVertex_w a, ShearedVertex_w b) { return difference_of_products_w(b.x, a.y, b.y, a.x); }

/// A value with the sign of e for the shifted ray; like e it is antisymmetric in a and b.
FN realw resolved_edge_w(realw e, ShearedVertex_w a, ShearedVertex_w b) {
  realw zero = splat_w(R(0.0));
  realw dy = b.y - a.y, dx = a.x - b.x;
  return sel_w(eq_w(e, zero), sel_w(eq_w(dy, zero), dx, dy), e);
}

/// Lanes whose values have different signs.
FN maskw signs_differ_w(realw a, realw b, realw c) {
  realw zero = splat_w(R(0.0));
  maskw negative = lt_w(a, zero) | lt_w(b, zero) | lt_w(c, zero);
  maskw positive = lt_w(zero, a) | lt_w(zero, b) | lt_w(zero, c);
  return negative & positive;
}

/// t, held within z_min ... z_max, a polygon's range along the ray's largest axis.
FN realw within_range_w(const Ray* ray, realw t, realw z_min, realw z_max) {
  realw one = z_min * splat_w(ray->shear_z), other = z_max * splat_w(ray->shear_z);
  realw first = min_w(one, other), last = max_w(one, other);
  t = sel_w(lt_w(t, first), first, t);
  return sel_w(lt_w(last, t), last, t);
}
