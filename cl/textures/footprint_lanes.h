// SPDX-License-Identifier: MIT
// textures/footprint.h in lanes, without the instances' part. One width; no guard.

FN realw pixel_footprint_w(const Scene* scene, realw travelled, real3w normal, real3w d) {
  GLOBAL const real* camera = scene->shading + scene->index[HEADER_CAMERA];
  realw spread = splat_w(length3(load3(camera + CAMERA_DX)) / length3(load3(camera + CAMERA_D)));
  realw half_width = fma_w(spread, travelled, splat_w(length3(load3(camera + CAMERA_OX))));
  realw cosine = abs_w(dot3_w(normal, d)) / length3_w(d);
  return splat_w(R(2.0)) * half_width / (splat_w((real)scene->index[HEADER_WIDTH]) * cosine);
}
