// SPDX-License-Identifier: MIT
// Two colours in squares of 1/2 by 1/2 of the mapped (u, v), four to a unit, as in Mitsuba's plugin.
// Parameters: colour 0, colour 1 (r g b each), then the map: u' = m0 u + m1 v + m2, v' = m3 u + m4 v + m5.
//
// The footprint is the pixel's where rays go through pixels' centres, and an eighth of it where samples are spread over
// the pixel, which filter by themselves (M. Pharr et al., "Physically Based Rendering", 4th ed., 10.1.3, take no less
// either): it is too wide on slants and where a mesh is stretched, which pictures of many samples would show.
// Where paths come from lights there is none.
// Up to a footprint of half a square the value is that of the point. Beyond, it is the exact mean over a box of the
// footprint's size (A. Apodaca, L. Gritz, "Advanced RenderMan", 2000, ch. 11, do it with the integral of the wave as
// here). The footprint is at least the distance between neighbouring values of the coordinate. So where this distance
// approaches a square the mean is used, for any pixel size. One width; no guard.

/// Integral from 0 to x of the wave that is +1 on (0, 1/2], -1 on (1/2, 1]: it has period 1 and lies in [0, 1/2].
FN realw checker_integral_w(realw x) {
  realw f = x - floor_w(x);
  return sel_w(lt_w(splat_w(R(0.5)), f), splat_w(R(1.0)) - f, f);
}

/// The wave at x, or its mean over a box of the given width around x.
FN realw checker_wave_w(realw x, realw width) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0));
  realw spacing = splat_w(R(4.0) * real_roundoff()) * abs_w(x);
  width = sel_w(lt_w(width, spacing), spacing, width);
  maskw is_finite = finite_w(width) & finite_w(x);
  realw point = sel_w(lt_w(splat_w(R(0.5)), x - floor_w(x)), -one, one);
  realw half_width = splat_w(R(0.5)) * width;
  realw mean = (checker_integral_w(x + half_width) - checker_integral_w(x - half_width)) / width;
  mean = max_w(min_w(mean, one), -one);  // Rounded beyond where the box is as wide as a real tells it.
  return sel_w(is_finite, sel_w(lt_w(splat_w(R(0.25)), width), mean, point), zero);
}

/// Both colours are flat.
FN Real2_w checkerboard_slope_w(const Scene* scene, GLOBAL const int* row, TexturePlace_w at) {
  (void)scene;
  (void)row;
  (void)at;
  Real2_w slope;
  slope.x = slope.y = splat_w(R(0.0));
  return slope;
}

FN real3w checkerboard_value_w(const Scene* scene, GLOBAL const int* row, TexturePlace_w at) {
  GLOBAL const real* params = scene->shading + row[TEXTURE_REALS];
  GLOBAL const real* m = params + 6;
  Real2_w p = mapped_uv_w(m, at.u, at.v);
  realw part = splat_w(row[TEXTURE_FILTER] > 1 ? R(1.0) / (real)row[TEXTURE_FILTER] : R(1.0));
  realw width_x = part * fma_w(splat_w(real_abs(m[0])), at.du, splat_w(real_abs(m[1])) * at.dv);
  realw width_y = part * fma_w(splat_w(real_abs(m[3])), at.du, splat_w(real_abs(m[4])) * at.dv);
  // 1: all of colour 0. Weights before the sum, so that each colour comes out exactly.
  realw even = splat_w(R(0.5)), one = splat_w(R(1.0));
  realw share = fma_w(even * checker_wave_w(p.x, width_x), checker_wave_w(p.y, width_y), even);
  return fma3_w(share, splat3_w(load3(params)), scale3_w(one - share, splat3_w(load3(params + 3))));
}
