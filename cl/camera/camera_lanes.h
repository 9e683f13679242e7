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

/// Quantile u of the pixel filter, linear between the table's entries.
FN realw filter_offset_w(GLOBAL const real* quantiles, realw u) {
  realw cell = u * splat_w((real)FILTER_CELLS);
  intw i = int_of_real_w(cell);
  realw low = gather_w(quantiles, i);
  return fma_w(cell - real_of_uint_w(uint_of_int_w(i)), gather_w(quantiles + 1, i) - low, low);
}
