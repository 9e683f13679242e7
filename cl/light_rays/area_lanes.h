// SPDX-License-Identifier: MIT
// A surface that emits: directions are drawn in proportion to their cosine.

FN LightRay_w area_ray_w(const Scene* scene, GLOBAL const int* row, LightNumbers_w numbers, Real2_w way) {
  GLOBAL const real* params = scene->shading + row[LIGHT_REALS];
  LightRay_w ray = area_place_w(scene, row, numbers);
  ray.is_surface = ~none_w();
  ray.inverse = splat_w(R(1.0));
  Frame_w frame = frame_around_w(ray.normal);
  ray.way = from_frame_w(&frame, square_to_cosine_hemisphere_w(way.x, way.y));
  ray.flux = scale3_w(splat_w(PI / params[AREA_INVERSE]), ray.flux);
  return ray;
}

FN realw area_spread_w(const Scene* scene, GLOBAL const int* row, real3w way) {
  (void)way;
  return splat_w(scene->shading[row[LIGHT_REALS] + AREA_INVERSE] / PI);
}
