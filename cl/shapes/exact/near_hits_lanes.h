// SPDX-License-Identifier: MIT
// Rays whose hits are known except for the last digits of t, one a lane, robust tier. One width; no guard.

typedef struct {
  real3w o, d;
  realw t_min, dd, dd_rest, dd_inverse, shear_z;  ///< As in rays/ray.h.
  maskw is_x, is_y;                               ///< Lanes whose largest axis is x or y.
} ExactRays_w;

#if LANES == 1
/// Written through a pointer: Oclgrind 21.10 does not support the attributes that LLVM gives to a struct returned in
/// memory.
FN void exact_ray(const Ray* ray, ExactRays_w* one) {
  one->o = ray->o;
  one->d = ray->d;
  one->t_min = ray->t_min;
  one->dd = ray->dd;
  one->dd_rest = ray->dd_rest;
  one->dd_inverse = ray->dd_inverse;
  one->shear_z = ray->shear_z;
  one->is_x = ~nonzero_w(ray->kz);
  one->is_y = ~nonzero_w(ray->kz - 1);
}
#endif
