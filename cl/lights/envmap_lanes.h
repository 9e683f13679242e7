// SPDX-License-Identifier: MIT
// Radiance from infinitely far away, by a latitude-longitude image as in Mitsuba's plugin: row 0 is the pole +y, the
// last row -y; a direction is (sin phi sin theta, cos theta, -cos phi sin theta) with theta = pi v and phi = 2 pi u,
// and columns have their middles at u = (column + 1/2) / width. A cell lies between four texels, and radiance is
// bilinear in it. How directions are drawn, and why so: docs/decisions/0024-textures.md. Parameters: scene/layout.h,
// ENVMAP_....
#include "math/atan2_lanes.h"
#include "textures/texels_lanes.h"

enum { envmap_NUMBERS_w = NUMBERS_TEXEL_w };

/// A place in a cell.
typedef struct {
  intw row, column;  ///< Of the corner whose two are the smallest.
  realw s, t;        ///< Along the row and across it, in [0, 1].
} EnvmapPlace_w;

/// The texels at its corners: first and second column of the upper and of the lower row.
typedef struct {
  real3w upper_first, upper_second, lower_first, lower_second;
} EnvmapCorners_w;

WIDE_FN EnvmapCorners_w envmap_corners_w(const Scene* scene, GLOBAL const int* row, const EnvmapPlace_w* p) {
  GLOBAL const int* image = scene->index + row[LIGHT_IMAGE];
  int width = image[IMAGE_WIDTH];
  intw next = p->column + splat_int_w(1), upper = p->row * splat_int_w(width), lower = upper + splat_int_w(width);
  next = sel_int_w(lt_int_w(next, splat_int_w(width)), next, splat_int_w(0));
  EnvmapCorners_w corners;
  corners.upper_first = texel_w(scene, image, upper + p->column);
  corners.upper_second = texel_w(scene, image, upper + next);
  corners.lower_first = texel_w(scene, image, lower + p->column);
  corners.lower_second = texel_w(scene, image, lower + next);
  return corners;
}

FN real3w envmap_radiance_w(const Scene* scene, GLOBAL const int* row, const EnvmapCorners_w* c,
                            const EnvmapPlace_w* p) {
  real3w upper = mean3_w(p->s, c->upper_first, c->upper_second), lower = mean3_w(p->s, c->lower_first, c->lower_second);
  real3w scale = splat3_w(load3(scene->shading + row[LIGHT_REALS] + ENVMAP_SCALE));
  return mul3_w(scale, mean3_w(p->t, upper, lower));
}

/// As far as it is drawn.
FN realw envmap_luminance_w(const Scene* scene, GLOBAL const int* row, real3w texel) {
  realw zero = splat_w(R(0.0)), least = splat_w(scene->shading[row[LIGHT_REALS] + ENVMAP_FLOOR]);
  realw y =
      fma_w(splat_w(R(0.072169)), texel.z, fma_w(splat_w(R(0.71516)), texel.y, splat_w(R(0.212671)) * texel.x)) - least;
  return sel_w(lt_w(zero, y), y, zero);
}

/// The luminances at the corners.
typedef struct {
  realw upper_first, upper_second, lower_first, lower_second;
} EnvmapLuminances_w;

FN EnvmapLuminances_w envmap_luminances_w(const Scene* scene, GLOBAL const int* row, const EnvmapCorners_w* c) {
  EnvmapLuminances_w y;
  y.upper_first = envmap_luminance_w(scene, row, c->upper_first);
  y.upper_second = envmap_luminance_w(scene, row, c->upper_second);
  y.lower_first = envmap_luminance_w(scene, row, c->lower_first);
  y.lower_second = envmap_luminance_w(scene, row, c->lower_second);
  return y;
}

FN realw between_w(realw share, realw a, realw b) { return fma_w(share, b, (splat_w(R(1.0)) - share) * a); }

/// Per solid angle, where the angle from the pole has that sine.
FN realw envmap_place_density_w(const Scene* scene, GLOBAL const int* row, const EnvmapLuminances_w* y,
                                const EnvmapPlace_w* p, realw sine) {
  realw luminance = between_w(p->t, between_w(p->s, y->upper_first, y->upper_second),
                              between_w(p->s, y->lower_first, y->lower_second));
  // The pole itself, which only a given direction meets.
  realw least = splat_w(real_roundoff() * real_roundoff());
  sine = sel_w(lt_w(least, sine), sine, least);
  return luminance * gather_w(scene->shading + row[LIGHT_REALS] + ENVMAP_ROWS, p->row) / sine;
}

/// x in [0, 1] with a density that is linear in it, in proportion to a at 0 and b at 1: the root of a quadratic
/// equation, without cancellation.
FN realw linear_place_w(realw number, realw a, realw b) {
  realw largest = max_w(a, b), zero = splat_w(R(0.0)), one = splat_w(R(1.0));
  maskw is_dark = ~lt_w(zero, largest);
  a = sel_w(is_dark, one, a / largest);
  b = sel_w(is_dark, one, b / largest);
  realw x = number * (a + b) / (a + sqrt_w(between_w(number, a * a, b * b)));
  return sel_w(lt_w(x, one), x, one);
}

FN LightSample_w envmap_sample_w(const Scene* scene, const LightRows_w* at, real3w from, LightNumbers_w numbers) {
  GLOBAL const int* image = scene->index + at->row[LIGHT_IMAGE];
  GLOBAL const int* choices = scene->index + at->row[LIGHT_CHOICE];
  GLOBAL const real* axes = scene->shading + at->row[LIGHT_REALS] + ENVMAP_AXES;
  int width = image[IMAGE_WIDTH], rows = image[IMAGE_HEIGHT] - 1;
  (void)from;
  EnvmapPlace_w p;
  p.row = chosen_item_w(choices, splat_int_w(0), (uint)rows, numbers.row);
  p.column = chosen_item_w(choices, splat_int_w(rows) + p.row * splat_int_w(width), (uint)width, numbers.column);
  EnvmapCorners_w corners = envmap_corners_w(scene, at->row, &p);
  EnvmapLuminances_w y = envmap_luminances_w(scene, at->row, &corners);
  p.t = linear_place_w(numbers.v, y.upper_first + y.upper_second, y.lower_first + y.lower_second);
  p.s = linear_place_w(numbers.u, between_w(p.t, y.upper_first, y.lower_first),
                       between_w(p.t, y.upper_second, y.lower_second));
  realw one_half = splat_w(R(0.5)), zero = splat_w(R(0.0));
  realw column = real_of_uint_w(uint_of_int_w(p.column)) + (p.s + one_half);
  realw line = real_of_uint_w(uint_of_int_w(p.row)) + p.t;
  SinCos_w phi = sincos_turns_w(column / splat_w((real)width));
  SinCos_w theta = sincos_turns_w(one_half * (line / splat_w((real)rows)));
  LightSample_w s = no_light_w();
  real3w x = splat3_w(load3(axes)), z = splat3_w(load3(axes + 6));
  real3w level = fma3_w(phi.sine, x, scale3_w(-phi.cosine, z));
  s.towards = fma3_w(theta.cosine, splat3_w(load3(axes + 3)), scale3_w(theta.sine, level));
  s.t_max = splat_w(REAL_MAX);
  realw density = envmap_place_density_w(scene, at->row, &y, &p, theta.sine);
  maskw is_drawn = lt_w(zero, density);
  s.density = sel_w(is_drawn, density, s.density);
  s.radiance = sel3_w(is_drawn, envmap_radiance_w(scene, at->row, &corners, &p), s.radiance);
  return s;
}

/// Where a direction of any length leads, and the sine of its angle from the pole.
FN EnvmapPlace_w envmap_place_w(const Scene* scene, GLOBAL const int* row, real3w towards, PRIVATE realw* sine) {
  GLOBAL const int* image = scene->index + row[LIGHT_IMAGE];
  GLOBAL const real* axes = scene->shading + row[LIGHT_REALS] + ENVMAP_AXES;
  int width = image[IMAGE_WIDTH], rows = image[IMAGE_HEIGHT] - 1;
  real3w d = unit3_w(towards);
  realw x = dot3_w(d, splat3_w(load3(axes))), y = dot3_w(d, splat3_w(load3(axes + 3)));
  realw z = dot3_w(d, splat3_w(load3(axes + 6)));
  *sine = sqrt_w(fma_w(x, x, z * z));
  EnvmapPlace_w p;
  realw column = fma_w(splat_w((real)width), atan2_turns_w(x, -z), splat_w(R(-0.5))), left = floor_w(column);
  p.s = column - left;
  p.column = int_of_real_w(left);
  intw first = splat_int_w(0), last = splat_int_w(width - 1), lowest = splat_int_w(rows - 1);
  p.column = sel_int_w(lt_int_w(p.column, first), last, p.column);
  p.column = sel_int_w(lt_int_w(last, p.column), last, p.column);
  realw line = splat_w(R(2.0) * (real)rows) * atan2_turns_w(*sine, y);
  p.row = int_of_real_w(line);
  p.row = sel_int_w(lt_int_w(p.row, lowest), p.row, lowest);
  p.row = sel_int_w(lt_int_w(p.row, first), first, p.row);
  p.t = line - real_of_uint_w(uint_of_int_w(p.row));
  return p;
}

FN FoundLight_w envmap_background_w(const Scene* scene, GLOBAL const int* row, real3w towards) {
  realw sine;
  EnvmapPlace_w p = envmap_place_w(scene, row, towards, &sine);
  EnvmapCorners_w corners = envmap_corners_w(scene, row, &p);
  EnvmapLuminances_w y = envmap_luminances_w(scene, row, &corners);
  FoundLight_w found;
  found.radiance = envmap_radiance_w(scene, row, &corners, &p);
  found.density = envmap_place_density_w(scene, row, &y, &p, sine);
  return found;
}

FN realw envmap_density_w(const Scene* scene, const LightRows_w* at, real3w from, real3w towards, const Surfaces_w* s) {
  (void)from;
  (void)s;
  return envmap_background_w(scene, at->row, towards).density;
}

#if HAS_LIGHT_PATHS
FN LightRay_w envmap_ray_w(const Scene* scene, GLOBAL const int* row, LightNumbers_w numbers, Real2_w way) {
  LightRows_w at = rows_of_light_w(scene, row);
  return far_ray_w(scene, envmap_sample_w(scene, &at, anywhere_w(), numbers), way);
}

FN realw envmap_spread_w(const Scene* scene, GLOBAL const int* row, real3w way) {
  (void)row;
  (void)way;
  return far_spread_w(scene);
}
#endif
