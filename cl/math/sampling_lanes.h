// SPDX-License-Identifier: MIT
// From the unit square to disks, hemispheres, spheres and triangles, and frames around a direction, in lanes: with
// + - * / fma sqrt only, angles as in math/sincos_lanes.h. Held by tests/cl/test_sampling.cpp against closed forms. One
// width; no guard.
#include "math/sincos_lanes.h"

#define ONE_OVER_PI R(0.318309886183790671538)

typedef struct {
  realw x, y;
} Real2_w;

/// Uniform on the unit disk; concentric squares are mapped onto circles.
/// P. Shirley, K. Chiu, "A Low Distortion Map Between Disk and Square", Journal of Graphics Tools 2(3), 1997.
FN Real2_w square_to_disk_w(realw u, realw v) {
  Real2_w p;
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), two = splat_w(R(2.0));
  realw a = fma_w(two, u, -one), b = fma_w(two, v, -one);
  maskw is_wide = lt_w(abs_w(b), abs_w(a));
  realw radius = sel_w(is_wide, a, b), across = sel_w(is_wide, b, a);
  realw eighth = sel_w(eq_w(radius, zero), zero, splat_w(R(0.125)) * (across / radius));
  SinCos_w turned = sincos_eighth_w(eighth);
  p.x = radius * sel_w(is_wide, turned.cosine, turned.sine);
  p.y = radius * sel_w(is_wide, turned.sine, turned.cosine);
  return p;
}

/// Unit, z > 0, density z / pi: N. Malley's method, the disk's points lifted onto the hemisphere.
FN real3w square_to_cosine_hemisphere_w(realw u, realw v) {
  Real2_w p = square_to_disk_w(u, v);
  realw rest = fma_w(-p.x, p.x, fma_w(-p.y, p.y, splat_w(R(1.0))));
  // The corners of the square are the horizon, which has no density; rounding must not lead below it.
  realw least = splat_w(R(2.0) * real_roundoff());
  return vec3_w(p.x, p.y, sqrt_w(sel_w(lt_w(least, rest), rest, least)));
}

/// Unit, uniform over all directions: density 1 / (4 pi).
FN real3w square_to_sphere_w(realw u, realw v) {
  realw one = splat_w(R(1.0)), two = splat_w(R(2.0)), radius = two * sqrt_w(u * (one - u));
  SinCos_w turned = sincos_turns_w(v);
  return vec3_w(radius * turned.cosine, radius * turned.sine, fma_w(-two, u, one));
}

/// Weights of two of the corners, uniform over the triangle.
/// E. Heitz, "A Low-Distortion Map Between Triangle and Square", 2019.
FN Real2_w square_to_triangle_w(realw u, realw v) {
  Real2_w weights;
  maskw is_first = lt_w(u, v);
  realw less = splat_w(R(0.5)) * sel_w(is_first, u, v);
  weights.x = sel_w(is_first, less, u - less);
  weights.y = sel_w(is_first, v - less, less);
  return weights;
}

/// Two unit vectors that make a right-handed frame with a third, z.
typedef struct {
  real3w x, y, z;
} Frame_w;

/// z: unit. T. Duff and others, "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017.
FN Frame_w frame_around_w(real3w z) {
  Frame_w f;
  realw one = splat_w(R(1.0)), sign = sel_w(lt_w(z.z, splat_w(R(0.0))), -one, one);
  realw a = -one / (sign + z.z), b = z.x * z.y * a;
  f.x = vec3_w(fma_w(sign * z.x * z.x, a, one), sign * b, -sign * z.x);
  f.y = vec3_w(b, fma_w(z.y * z.y, a, sign), -z.y);
  f.z = z;
  return f;
}

/// The same with x along a direction as far as z lets it; where that is 0, as frame_around.
FN Frame_w frame_along_w(real3w z, real3w along) {
  Frame_w f = frame_around_w(z), turned = f;
  real3w x = normalize3_w(fma3_w(-dot3_w(along, z), z, along));
  turned.x = x;
  turned.y = cross3_w(z, x);
  maskw is_along = lt_w(splat_w(R(0.0)), dot3_w(x, x));
  f.x = sel3_w(is_along, turned.x, f.x);
  f.y = sel3_w(is_along, turned.y, f.y);
  return f;
}

FN real3w from_frame_w(const Frame_w* f, real3w a) { return fma3_w(a.z, f->z, fma3_w(a.y, f->y, scale3_w(a.x, f->x))); }

FN real3w to_frame_w(const Frame_w* f, real3w a) { return vec3_w(dot3_w(a, f->x), dot3_w(a, f->y), dot3_w(a, f->z)); }
