// SPDX-License-Identifier: MIT
// An image over (u, v), whose row 0 is at v = 0, as in Mitsuba's plugin: the texel nearest to the point, or the
// bilinear mean of the four around it. Beyond [0, 1] the image is repeated, mirrored, or continued by its edge.
// Where the row has several levels and the pixel is wider than a texel, the value is taken between the two levels whose
// texels are next to the pixel's width (L. Williams, "Pyramidal Parametrics", SIGGRAPH 1983).
// Parameters: the map of (u, v), as of a checkerboard; then what multiplies the texels, r g b. One width; no guard.
#include "textures/neighbours_lanes.h"
#include "textures/texels_lanes.h"

/// Of one level, at mapped (u, v).
FN real3w bitmap_level_w(const Scene* scene, GLOBAL const int* row, int level, Real2_w p) {
  GLOBAL const int* image = scene->index + row[TEXTURE_IMAGE] + level * IMAGE_INTS;
  int wrap = row[TEXTURE_WRAP], filter = row[TEXTURE_FILTER], width = image[IMAGE_WIDTH];
  Neighbours_w x = neighbours_w(wrapped_w(p.x, wrap), width, wrap, filter);
  Neighbours_w y = neighbours_w(wrapped_w(p.y, wrap), image[IMAGE_HEIGHT], wrap, filter);
  intw first = y.first * splat_int_w(width), second = y.second * splat_int_w(width);
  if (filter == FILTER_NEAREST) return texel_w(scene, image, first + x.first);
  real3w above = mean3_w(x.weight, texel_w(scene, image, first + x.first), texel_w(scene, image, first + x.second));
  real3w below = mean3_w(x.weight, texel_w(scene, image, second + x.first), texel_w(scene, image, second + x.second));
  return mean3_w(y.weight, above, below);
}

/// How many texels of the first level a pixel is wide, at least 1 and at most a texel of the last level.
FN realw texels_a_pixel_w(const Scene* scene, GLOBAL const int* row, TexturePlace_w at) {
  GLOBAL const int* image = scene->index + row[TEXTURE_IMAGE];
  GLOBAL const real* m = scene->shading + row[TEXTURE_REALS];
  realw x = fma_w(splat_w(real_abs(m[0])), at.du, splat_w(real_abs(m[1])) * at.dv);
  realw y = fma_w(splat_w(real_abs(m[3])), at.du, splat_w(real_abs(m[4])) * at.dv);
  realw most = splat_w((real)(1 << (row[TEXTURE_LEVELS] - 1))), one = splat_w(R(1.0));
  realw width = max_w(splat_w((real)image[IMAGE_WIDTH]) * x, splat_w((real)image[IMAGE_HEIGHT]) * y);
  // An infinite footprint times a rate of 0 is as wide as it can be.
  width = sel_w(lt_w(width, most), width, most);
  return sel_w(lt_w(width, one), one, width);
}

/// 1, or -1 where the image is mirrored.
FN realw direction_w(realw x, int wrap) {
  realw one = splat_w(R(1.0)), turns = splat_w(R(0.5)) * x;
  return sel_w(lt_w(splat_w(R(0.5)), turns - floor_w(turns)), wrap == WRAP_MIRROR ? -one : one, one);
}

/// How the luminance of the bilinear mean, of the first level, changes with u and v.
FN Real2_w bitmap_slope_w(const Scene* scene, GLOBAL const int* row, TexturePlace_w at) {
  GLOBAL const real* m = scene->shading + row[TEXTURE_REALS];
  GLOBAL const int* image = scene->index + row[TEXTURE_IMAGE];
  Real2_w p = mapped_uv_w(m, at.u, at.v), slope;
  int wrap = row[TEXTURE_WRAP], filter = row[TEXTURE_FILTER], width = image[IMAGE_WIDTH], height = image[IMAGE_HEIGHT];
  Neighbours_w x = neighbours_w(wrapped_w(p.x, wrap), width, wrap, filter);
  Neighbours_w y = neighbours_w(wrapped_w(p.y, wrap), height, wrap, filter);
  intw first = y.first * splat_int_w(width), second = y.second * splat_int_w(width);
  real3w scale = splat3_w(load3(m + 6));
  realw a = luminance_w(mul3_w(scale, texel_w(scene, image, first + x.first)));
  realw b = luminance_w(mul3_w(scale, texel_w(scene, image, first + x.second)));
  realw c = luminance_w(mul3_w(scale, texel_w(scene, image, second + x.first)));
  realw d = luminance_w(mul3_w(scale, texel_w(scene, image, second + x.second)));
  realw along = splat_w((real)width) * direction_w(p.x, wrap) * fma_w(y.weight, (d - c) - (b - a), b - a);
  realw across = splat_w((real)height) * direction_w(p.y, wrap) * fma_w(x.weight, (d - b) - (c - a), c - a);
  slope.x = fma_w(splat_w(m[0]), along, splat_w(m[3]) * across);
  slope.y = fma_w(splat_w(m[1]), along, splat_w(m[4]) * across);
  return slope;
}

FN real3w bitmap_value_w(const Scene* scene, GLOBAL const int* row, TexturePlace_w at) {
  GLOBAL const real* params = scene->shading + row[TEXTURE_REALS];
  Real2_w p = mapped_uv_w(params, at.u, at.v);
  real3w value = bitmap_level_w(scene, row, 0, p);
  if (HAS_TEXTURE_LOD && row[TEXTURE_LEVELS] > 1) {
    realw width = texels_a_pixel_w(scene, row, at), one = splat_w(R(1.0)), lower = one;
    // Between two levels, linear in the width.
    for (int level = 0; level + 1 < row[TEXTURE_LEVELS]; ++level) {
      maskw is_wider = lt_w(lower, width);
      if (!any_w(is_wider)) break;
      realw share = width / lower - one;
      share = sel_w(lt_w(share, one), share, one);
      real3w wider = bitmap_level_w(scene, row, level + 1, p);
      value = sel3_w(is_wider, mean3_w(share, level == 0 ? value : bitmap_level_w(scene, row, level, p), wider), value);
      lower = lower + lower;
    }
  }
  return mul3_w(splat3_w(load3(params + 6)), value);
}
