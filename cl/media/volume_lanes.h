// SPDX-License-Identifier: MIT
// Values over a box in space (media/media_layout.h, VOLUME_...): the texel nearest to a place, or the trilinear mean of
// the eight around it. Beyond the box they are repeated, mirrored, or continued by its faces. One width; no guard.
#include "textures/neighbours_lanes.h"
#include "textures/texels_lanes.h"

/// Where `place` lies in the frame of the 12 reals: an origin, and three rows that turn and scale.
FN real3w in_box_frame_w(GLOBAL const real* frame, real3w place) {
  real3w p = sub3_w(place, splat3_w(load3(frame)));
  return vec3_w(dot3_w(splat3_w(load3(frame + 3)), p), dot3_w(splat3_w(load3(frame + 6)), p),
                dot3_w(splat3_w(load3(frame + 9)), p));
}

/// Between the two texels of a row. A lookup asks for four rows, and programs have four lookups.
ONCE_FN real3w along_row_w(const Scene* scene, GLOBAL const int* image, intw row, Neighbours_w x) {
  return mean3_w(x.weight, texel_w(scene, image, row + x.first), texel_w(scene, image, row + x.second));
}

/// Of each lane's place.
FN real3w volume_value_w(const Scene* scene, GLOBAL const int* row, real3w place) {
  GLOBAL const real* reals = scene->shading + row[VOLUME_REALS];
  real3w scale = splat3_w(load3(reals + VOLUME_SCALE));
  if (row[VOLUME_IMAGE] < 0) return scale;
  GLOBAL const int* image = scene->index + row[VOLUME_IMAGE];
  int wrap = row[VOLUME_WRAP], filter = row[VOLUME_FILTER], width = image[IMAGE_WIDTH], height = row[VOLUME_HEIGHT];
  realw half_side = splat_w(R(0.5));
  real3w p = in_box_frame_w(reals, place);
  Neighbours_w x = neighbours_w(wrapped_w(p.x + half_side, wrap), width, wrap, filter);
  Neighbours_w y = neighbours_w(wrapped_w(p.y + half_side, wrap), height, wrap, filter);
  Neighbours_w z = neighbours_w(wrapped_w(p.z + half_side, wrap), row[VOLUME_DEPTH], wrap, filter);
  intw w = splat_int_w(width), h = splat_int_w(height), below = z.first * h, above = z.second * h;
  if (filter == FILTER_NEAREST) return mul3_w(scale, texel_w(scene, image, (below + y.first) * w + x.first));
  real3w lower = mean3_w(y.weight, along_row_w(scene, image, (below + y.first) * w, x),
                         along_row_w(scene, image, (below + y.second) * w, x));
  real3w upper = mean3_w(y.weight, along_row_w(scene, image, (above + y.first) * w, x),
                         along_row_w(scene, image, (above + y.second) * w, x));
  return mul3_w(scale, mean3_w(z.weight, lower, upper));
}
