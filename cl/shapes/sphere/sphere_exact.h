// SPDX-License-Identifier: MIT
// sphere_exact_lanes.h for one ray and one sphere in a block, robust tier, one lane. prim: the sphere's own planes,
// `stride` apart.

/// Whether a ray that has left the sphere may meet it again at t: ahead, and within the slabs that the tree knows,
/// which an origin that is not on the sphere may miss.
FN int sphere_is_left_at(const Ray* ray, GLOBAL const real* prim, int stride, real t) {
  real x = prim[0], y = prim[stride], z = prim[2 * stride], r = prim[3 * stride];
  return R(0.0) < t && t == within_slabs_w(ray, t, x - r, x + r, y - r, y + r, z - r, z + r);
}

FN real3 center_of(GLOBAL const real* prim, int stride) { return vec3(prim[0], prim[stride], prim[2 * stride]); }

/// The first root from t_min on; for a sphere that the ray has left, the other root. hit: there is one.
FN real sphere_t_of(const Ray* ray, GLOBAL const real* prim, int stride, int is_departed, PRIVATE int* hit) {
  ExactRays_w one;
  exact_ray(ray, &one);
  real3 c = center_of(prim, stride);
  maskw met, which = ~none_w();
  if (is_departed) {
    real across = sphere_root_across_w(&one, c, which);
    *hit = sphere_is_left_at(ray, prim, stride, across);
    return across;
  }
  real t = sphere_root_w(&one, c, prim[3 * stride], which, &met);
  *hit = met != 0;
  return t;
}

/// Decides one sphere that may be hit. The best hit so far has its exact t.
FN void sphere_decide(const Ray* ray, GLOBAL const real* prim, int stride, int id, int kind, int slot, Nearest* best) {
  int hit;
  real t = sphere_t_of(ray, prim, stride, ray->departed >= 0 && id == ray->departed, &hit);
  if (hit && ray->t_min <= t) nearest_take(best, t, id, kind, slot);
}

/// t of a sphere that is hit for certain, and has not been left.
FN real sphere_exact_t(const Ray* ray, GLOBAL const real* prim, int stride) {
  int hit;
  return sphere_t_of(ray, prim, stride, 0, &hit);
}
