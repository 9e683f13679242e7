// SPDX-License-Identifier: MIT
// Camera rays of pixels of one row. Perspective and orthographic are one affine map of the place on the picture
// (scene/layout.h); through a lens they begin anywhere on it and meet again at the plane of focus. The pixel's middle
// enters as the exact integer numerator 2 i + 1 - W: one rounding, so the picture of a mirrored scene is exactly
// mirrored. One width; no guard.

/// Pixels (x, y) of the whole picture; dx, dy: offset from its middle in pixels; lens: the place on the lens, in radii.
FN void camera_rays_w(GLOBAL const real* camera, int width, int height, intw x, int y, realw dx, realw dy, Real2_w lens,
                      Rays_w* rays) {
  realw two = splat_w(R(2.0));
  realw sx = fma_w(two, dx, real_of_int_w(x + x + splat_int_w(1 - width))) / splat_w((real)width);
  realw sy = fma_w(two, dy, splat_w((real)(2 * y + 1 - height))) / splat_w((real)height);
  real3w o = fma3_w(sx, splat3_w(load3(camera + CAMERA_OX)), splat3_w(load3(camera + CAMERA_O)));
  o = fma3_w(sy, splat3_w(load3(camera + CAMERA_OY)), o);
  real3w d = fma3_w(sx, splat3_w(load3(camera + CAMERA_DX)), splat3_w(load3(camera + CAMERA_D)));
  d = fma3_w(sy, splat3_w(load3(camera + CAMERA_DY)), d);
  if (HAS_THIN_LENS) {
    real3w off = scale3_w(lens.x, splat3_w(load3(camera + CAMERA_LENS_U)));
    off = fma3_w(lens.y, splat3_w(load3(camera + CAMERA_LENS_V)), off);
    o = add3_w(o, off);
    d = fma3_w(splat_w(-camera[CAMERA_FOCUS]), off, d);
  }
  rays_make_w(o, d, splat_w(camera[CAMERA_NEAR]), splat_w(camera[CAMERA_FAR]), none_w(), rays);
  rays->departed = rays->departed_instance = rays->aim = splat_int_w(-1);
  rays->is_outward = splat_int_w(0);
}

/// Quantile u of the pixel filter, linear in u between the table's entries. These are of tails, of squared shares, and
/// so the closer the nearer to the ends: a thousandth of a gaussian reaches over a quarter of its width.
FN realw filter_offset_w(GLOBAL const real* quantiles, realw u) {
  realw cells = splat_w((real)FILTER_CELLS), both = fma_w(splat_w(R(2.0)), u, splat_w(-R(1.0)));
  realw tail = splat_w(R(1.0)) - abs_w(both);
  intw last = splat_int_w(FILTER_CELLS - 1), i = int_of_real_w(cells * sqrt_w(tail));
  i = sel_int_w(lt_int_w(last, i), last, i);
  realw low = real_of_int_w(i), beyond = fma_w(cells * cells, tail, -(low * low));
  realw outer = gather_w(quantiles, i), steps = fma_w(splat_w(R(2.0)), low, splat_w(R(1.0)));
  realw offset = fma_w(beyond / steps, gather_w(quantiles + 1, i) - outer, outer);
  return sel_w(lt_w(both, splat_w(R(0.0))), -offset, offset);
}
