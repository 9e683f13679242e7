// SPDX-License-Identifier: MIT
// Camera rays. Perspective and orthographic are one affine map of the place on the picture (scene/layout.h).
// The pixel's middle enters as the exact integer numerator 2 i + 1 - W: one rounding, so the picture of a mirrored
// scene is exactly mirrored.
#ifndef STRAHL_CORE_CAMERA_H
#define STRAHL_CORE_CAMERA_H

#include "core/ray.h"
#include "scene/layout.h"

/// Pixel (x, y) of the whole picture; dx, dy: offset from its middle in pixels.
FN Ray camera_ray(GLOBAL const real* camera, int width, int height, int x, int y, real dx, real dy) {
  real sx = real_fma(R(2.0), dx, (real)(2 * x + 1 - width)) / (real)width;
  real sy = real_fma(R(2.0), dy, (real)(2 * y + 1 - height)) / (real)height;
  real3 o = fma3(sy, load3(camera + CAMERA_OY), fma3(sx, load3(camera + CAMERA_OX), load3(camera + CAMERA_O)));
  real3 d = fma3(sy, load3(camera + CAMERA_DY), fma3(sx, load3(camera + CAMERA_DX), load3(camera + CAMERA_D)));
  return ray_make(o, d, camera[CAMERA_NEAR], camera[CAMERA_FAR], -1);
}

/// Quantile u of the pixel filter, linear between the table's entries.
FN real filter_offset(GLOBAL const real* quantiles, real u) {
  real cell = u * (real)FILTER_CELLS;
  int i = (int)cell;
  real low = quantiles[i];
  return real_fma(cell - (real)i, quantiles[i + 1] - low, low);
}

#endif
