// SPDX-License-Identifier: MIT
// A ray that leaves a light, for paths that begin there. One width; no guard.

#define PI R(3.14159265358979323846)

typedef struct {
  real3w from, way;  ///< way: unit.
  real3w flux;       ///< What one such ray carries: radiance or intensity over the density with which it was drawn.
  real3w normal;     ///< Of the light's surface, on the side that emits; undefined where it has none.
  realw bound;       ///< The place may be so far off the surface.
  maskw is_surface;  ///< The flux over pi leaves the place into each unit of solid angle, times the cosine.
  maskw is_far;      ///< The light is infinitely far away.
  realw inverse;     ///< One over the density of a far light's direction, per solid angle; of a surface 1; 0: no ray
                     ///< finds the light.
} LightRay_w;

FN LightRay_w no_light_ray_w(void) {
  LightRay_w ray;
  realw zero = splat_w(R(0.0));
  ray.from = ray.way = ray.flux = ray.normal = vec3_w(zero, zero, zero);
  ray.bound = ray.inverse = zero;
  ray.is_far = none_w();
  ray.is_surface = none_w();
  return ray;
}
