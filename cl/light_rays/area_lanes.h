// SPDX-License-Identifier: MIT
// A surface that emits: places are drawn uniformly from its area, directions in proportion to their cosine.

/// The first point of an item. Of a sphere it is the centre, from where the whole area is drawn from uniformly; other
/// areas are drawn from uniformly anyway.
FN real3w area_origin_w(const Scene* scene, GLOBAL const int* row, intw item) {
  GLOBAL const real* params = scene->shading + row[LIGHT_REALS];
  int stride = 0;
  switch (row[LIGHT_AREA]) {
#define AREA(name, reals) \
  case AREA_##name:       \
    stride = (reals);     \
    break;
#include "areas/areas.def"
#undef AREA
    default:
      break;
  }
  return gather3_w(params + AREA_ITEMS, item * stride);
}

FN LightRay_w area_ray_w(const Scene* scene, GLOBAL const int* row, LightNumbers_w numbers, Real2_w way) {
  GLOBAL const real* params = scene->shading + row[LIGHT_REALS];
  intw item = area_item_w(scene, row, numbers.item);
  AreaPoint_w p = area_point_w(scene, row, area_origin_w(scene, row, item), item, numbers.u, numbers.v);
  LightRay_w ray = no_light_ray_w();
  ray.from = p.position;
  ray.normal = p.normal;
  ray.bound = area_rounding_w(p.position, p.position);
  ray.is_surface = ~none_w();
  ray.inverse = splat_w(R(1.0));
  real3w radiance = splat3_w(load3(params + AREA_RADIANCE));
  if (HAS_LIGHT_TEXTURE && row[LIGHT_TEXTURE] >= 0) radiance = mul3_w(radiance, area_texture_w(scene, row, item, &p));
  Frame_w frame = frame_around_w(p.normal);
  ray.way = from_frame_w(&frame, square_to_cosine_hemisphere_w(way.x, way.y));
  ray.flux = scale3_w(splat_w(PI / params[AREA_INVERSE]), radiance);
  return ray;
}

FN realw area_spread_w(const Scene* scene, GLOBAL const int* row, real3w way) {
  (void)way;
  return splat_w(scene->shading[row[LIGHT_REALS] + AREA_INVERSE] / PI);
}
