// SPDX-License-Identifier: MIT
// Sphere: centre, radius. From outside, directions are drawn uniformly from the cone that the sphere fills: P. Shirley,
// C. Wang, K. Zimmerman, "Monte Carlo Techniques for Direct Lighting Calculations", ACM TOG 15(1), 1996. The formulas
// use 1 - cos and ratios of sines, so that nothing cancels for a small or distant sphere. From inside, where only a
// sphere that emits inwards is visible, places are drawn uniformly from its area.
#include "math/atan2_lanes.h"

typedef struct {
  real3w axis;  ///< Unit, towards the centre.
  realw sine;   ///< Of half the opening; not below 1: from inside.
  realw less;   ///< 1 - its cosine.
  maskw is_outside;
} SphereCone_w;

FN SphereCone_w sphere_cone_w(PRIVATE const realw* item, real3w from) {
  SphereCone_w cone;
  real3w to_centre = sub3_w(real3_at_w(item), from);
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), radius = item[3], distance = length3_w(to_centre);
  cone.axis = scale3_w(one / distance, to_centre);
  cone.sine = radius / distance;
  realw square = (distance - radius) * (distance + radius);
  realw cosine = sel_w(lt_w(zero, square), sqrt_w(square) / distance, zero);
  cone.less = cone.sine * cone.sine / (one + cosine);
  cone.is_outside = lt_w(cone.sine, one);
  return cone;
}

FN realw sphere_cone_density_w(PRIVATE const realw* area, const SphereCone_w* cone) {
  realw zero = splat_w(R(0.0));
  return sel_w(lt_w(zero, area[AREA_SIDE]), splat_w(R(0.5) * ONE_OVER_PI) / cone->less, zero);
}

FN AreaPoint_w sphere_point_w(PRIVATE const realw* item, PRIVATE const realw* area, real3w from, realw u, realw v) {
  real3w centre = real3_at_w(item);
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), two = splat_w(R(2.0)), radius = item[3];
  SphereCone_w cone = sphere_cone_w(item, from);
  Real2_w disk = square_to_disk_w(u, v);
  realw square = fma_w(disk.x, disk.x, disk.y * disk.y);  // Share of the cone's solid angle.
  realw less = square * cone.less, cosine = one - less;
  // sin theta / sin theta_max = sqrt(square) ratio; the angle at the centre is asin of that, less theta.
  realw ratio = sqrt_w((two - less) / (two - cone.less));
  realw relative = fma_w(-square, ratio * ratio, one), foot = sqrt_w(sel_w(lt_w(zero, relative), relative, zero));
  realw across = ratio * fma_w(-foot, cone.sine, cosine);
  realw along = fma_w(foot, cosine, square * ratio * ratio * cone.sine);
  Frame_w frame = frame_around_w(cone.axis);
  AreaPoint_w p;
  p.normal = normalize3_w(from_frame_w(&frame, vec3_w(across * disk.x, across * disk.y, -along)));
  p.position = fma3_w(radius, p.normal, centre);
  p.density = sphere_cone_density_w(area, &cone);
  p.u = u;
  p.v = v;
  if (any_w(~cone.is_outside)) {
    real3w outward = square_to_sphere_w(u, v);
    AreaPoint_w within =
        uniform_point_w(area, from, fma3_w(radius, outward, centre), scale3_w(area[AREA_SIDE], outward), u, v);
    p.normal = sel3_w(cone.is_outside, p.normal, within.normal);
    p.position = sel3_w(cone.is_outside, p.position, within.position);
    p.density = sel_w(cone.is_outside, p.density, within.density);
  }
  return p;
}

FN realw sphere_reach_w(PRIVATE const realw* item) { return max3_w(abs3_w(real3_at_w(item))) + item[3]; }

FN realw sphere_density_w(PRIVATE const realw* item, PRIVATE const realw* area, real3w from, real3w towards,
                          real3w normal) {
  SphereCone_w cone = sphere_cone_w(item, from);
  return sel_w(cone.is_outside, sphere_cone_density_w(area, &cone), uniform_density_w(area, towards, normal));
}

/// uvs: the sphere's axes, x y z each. As cl/shapes/sphere/sphere.h has it.
FN Real2_w sphere_uv_w(GLOBAL const real* uvs, intw item, const AreaPoint_w* p, real side) {
  (void)item;
  real3w outward = scale3_w(splat_w(side), p->normal);
  realw x = dot3_w(outward, splat3_w(load3(uvs))), y = dot3_w(outward, splat3_w(load3(uvs + 3)));
  Real2_w uv;
  uv.x = atan2_turns_w(y, x);
  uv.y = splat_w(R(2.0)) * atan2_turns_w(sqrt_w(fma_w(x, x, y * y)), dot3_w(outward, splat3_w(load3(uvs + 6))));
  return uv;
}
