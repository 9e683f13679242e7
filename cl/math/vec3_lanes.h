// SPDX-License-Identifier: MIT
// math/vec3.h in lanes, operation by operation: the same bits. Once a width.
#include "math/vec3.h"

#if !(LANES == 1 && defined(STRAHL_VEC3_LANES_1)) && !(LANES == 8 && defined(STRAHL_VEC3_LANES_8)) && \
    !(LANES == 16 && defined(STRAHL_VEC3_LANES_16))
#if LANES == 1
#define STRAHL_VEC3_LANES_1
typedef real3 real3w;
#else
#if LANES == 8
#define STRAHL_VEC3_LANES_8
#else
#define STRAHL_VEC3_LANES_16
#endif
typedef struct {
  realw x, y, z;
} real3w;
#endif

FN real3w vec3_w(realw x, realw y, realw z) {
  real3w v;
  v.x = x;
  v.y = y;
  v.z = z;
  return v;
}

FN real3w real3_at_w(PRIVATE const realw* planes) { return vec3_w(planes[0], planes[1], planes[2]); }

/// v, its axes turned so that x becomes z in the lanes of is_x, and y in those of is_y.
FN real3w turned3_w(maskw is_x, maskw is_y, real3w v) {
  return vec3_w(sel_w(is_x, v.y, sel_w(is_y, v.z, v.x)), sel_w(is_x, v.z, sel_w(is_y, v.x, v.y)),
                sel_w(is_x, v.x, sel_w(is_y, v.y, v.z)));
}

/// Three planes of LANES reals.
FN real3w load_planes3_w(GLOBAL const real* planes) {
  return vec3_w(load_w(planes), load_w(planes + LANES), load_w(planes + 2 * LANES));
}

/// Of each lane's primitive, planes first, first + 1 and first + 2, `lanes` reals each. at: its place among them.
FN real3w gather_planes3_w(GLOBAL const real* planes, intw at, int first, int lanes) {
  planes += first * lanes;
  return vec3_w(gather_w(planes, at), gather_w(planes + lanes, at), gather_w(planes + 2 * lanes, at));
}

FN real3 get3_w(PRIVATE const real3w* v, int lane) {
  return vec3(get_w(&v->x, lane), get_w(&v->y, lane), get_w(&v->z, lane));
}

FN real3w splat3_w(real3 a) { return vec3_w(splat_w(a.x), splat_w(a.y), splat_w(a.z)); }
/// Three reals in a row, elsewhere for each lane.
FN real3w gather3_w(GLOBAL const real* p, intw i) {
  return vec3_w(gather_w(p, i), gather_w(p + 1, i), gather_w(p + 2, i));
}

FN real3w add3_w(real3w a, real3w b) { return vec3_w(a.x + b.x, a.y + b.y, a.z + b.z); }
FN real3w sub3_w(real3w a, real3w b) { return vec3_w(a.x - b.x, a.y - b.y, a.z - b.z); }
FN real3w mul3_w(real3w a, real3w b) { return vec3_w(a.x * b.x, a.y * b.y, a.z * b.z); }
FN real3w scale3_w(realw s, real3w a) { return vec3_w(s * a.x, s * a.y, s * a.z); }
FN real3w negate3_w(real3w a) { return vec3_w(-a.x, -a.y, -a.z); }

/// a + s b, one rounding a component.
FN real3w fma3_w(realw s, real3w b, real3w a) {
  return vec3_w(fma_w(s, b.x, a.x), fma_w(s, b.y, a.y), fma_w(s, b.z, a.z));
}

FN realw dot3_w(real3w a, real3w b) { return fma_w(a.z, b.z, fma_w(a.y, b.y, a.x * b.x)); }

FN real3w cross3_w(real3w a, real3w b) {
  return vec3_w(difference_of_products_w(a.y, b.z, a.z, b.y), difference_of_products_w(a.z, b.x, a.x, b.z),
                difference_of_products_w(a.x, b.y, a.y, b.x));
}

FN real3w abs3_w(real3w a) { return vec3_w(abs_w(a.x), abs_w(a.y), abs_w(a.z)); }

/// |x| + |y| + |z|.
FN realw size1_w(real3w v) { return abs_w(v.x) + abs_w(v.y) + abs_w(v.z); }
FN realw max3_w(real3w a) {
  realw m = sel_w(lt_w(a.x, a.y), a.y, a.x);
  return sel_w(lt_w(m, a.z), a.z, m);
}

/// Lanes in which light is not black. What is no number is not: the film counts it.
FN maskw not_black_w(real3w light) {
  realw zero = splat_w(R(0.0));
  return ~(le_w(light.x, zero) & le_w(light.y, zero) & le_w(light.z, zero));
}

/// m ? a : b.
FN real3w sel3_w(maskw m, real3w a, real3w b) {
  return vec3_w(sel_w(m, a.x, b.x), sel_w(m, a.y, b.y), sel_w(m, a.z, b.z));
}

/// One number from a colour: its luminance.
FN realw luminance_w(real3w rgb) {
  realw sum = fma_w(splat_w(R(0.2126)), rgb.x, fma_w(splat_w(R(0.7152)), rgb.y, splat_w(R(0.0722)) * rgb.z));
  // Where the channels are alike the sum may be off by rounding: opaque is opaque.
  maskw is_grey = eq_w(rgb.x, rgb.y) & eq_w(rgb.y, rgb.z);
  return sel_w(is_grey, rgb.x, sum);
}

FN real3w sqrt3_w(real3w a) { return vec3_w(sqrt_w(a.x), sqrt_w(a.y), sqrt_w(a.z)); }

FN real3w unit3_w(real3w v) {
  realw norm = sqrt_w(dot3_w(v, v));
  return vec3_w(v.x / norm, v.y / norm, v.z / norm);
}

/// The power of two that power_of_two_to_one divides by.
FN realw largest_power_w(real3w v) {
  realw m = max3_w(abs3_w(v));
  return sel_w(lt_w(splat_w(R(0.0)), m), power_of_two_w(m), splat_w(R(1.0)));
}

FN real3w normalize3_w(real3w v) {
  real3w w = scale3_w(inverse_power_w(largest_power_w(v)), v);
  realw norm = sqrt_w(dot3_w(w, w));
  norm = sel_w(lt_w(splat_w(R(0.0)), norm), norm, splat_w(R(1.0)));
  return vec3_w(w.x / norm, w.y / norm, w.z / norm);
}

FN realw length3_w(real3w v) {
  realw down = largest_power_w(v);
  real3w w = scale3_w(inverse_power_w(down), v);
  return sqrt_w(dot3_w(w, w)) * down;
}
#endif
