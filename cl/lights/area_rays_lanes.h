// SPDX-License-Identifier: MIT
// Where light leaves surfaces, of area and directionalarea: places are drawn uniformly from all of the area. One width;
// no guard.

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

/// A ray without a direction, whose flux is still the radiance or exitance there.
FN LightRay_w area_place_w(const Scene* scene, GLOBAL const int* row, LightNumbers_w numbers) {
  LightRows_w at = rows_of_light_w(scene, row);
  realw area[AREA_ITEMS];
  light_reals_w(scene, &at, AREA_ITEMS, area);
  intw item = area_item_w(scene, row, numbers.item);
  AreaPoint_w p = area_point_w(scene, &at, area, area_origin_w(scene, row, item), item, numbers.u, numbers.v);
  LightRay_w ray = no_light_ray_w();
  ray.from = p.position;
  ray.normal = p.normal;
  ray.bound = area_rounding_w(p.position, p.position, p.reach);
  real3w radiance = real3_at_w(area + AREA_RADIANCE);
  if (HAS_LIGHT_TEXTURE && row[LIGHT_TEXTURE] >= 0) radiance = mul3_w(radiance, area_texture_w(scene, row, item, &p));
  ray.flux = radiance;
  return ray;
}
