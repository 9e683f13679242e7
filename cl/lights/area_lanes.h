// SPDX-License-Identifier: MIT
// A surface that emits the same radiance in every direction on one side, the same everywhere or as a texture says; its
// places (lights/area_places_lanes.h) are drawn without regard to the texture, which is read at points. Parameters:
// scene/layout.h, AREA_....

enum { area_NUMBERS_w = NUMBERS_NONE_w };

FN LightSample_w area_sample_w(const Scene* scene, const LightRows_w* at, real3w from, LightNumbers_w numbers) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), area[AREA_ITEMS];
  intw item = area_item_w(scene, at->row, numbers.item), first_id = light_entry_w(scene, at, LIGHT_FIRST_ID);
  light_reals_w(scene, at, AREA_ITEMS, area);
  AreaPoint_w p = area_point_w(scene, at, area, from, item, numbers.u, numbers.v);
  realw bound = area_rounding_w(p.position, from, p.reach);
  LightSample_w s = no_light_w();
  s.towards = sub3_w(p.position, from);
  maskw is_lit = lt_w(zero, p.density) & lt_w(bound, -dot3_w(p.normal, s.towards));
#if TIER_FAST
  s.t_max = one - splat_w(FAST_EPSILON) / sqrt_w(dot3_w(s.towards, s.towards));
#else
  s.towards = fma3_w(bound, p.normal, s.towards);
  s.t_max = one;
#endif
  s.density = p.density;
  s.aim = sel_int_w(lt_int_w(first_id, splat_int_w(0)), s.aim, first_id + item);
  real3w radiance = real3_at_w(area + AREA_RADIANCE);
  if (HAS_LIGHT_TEXTURE && at->row[LIGHT_TEXTURE] >= 0)
    radiance = mul3_w(radiance, area_texture_w(scene, at->row, item, &p));
  s.radiance = sel3_w(is_lit, radiance, s.radiance);
  return s;
}

FN realw area_density_w(const Scene* scene, const LightRows_w* at, real3w from, real3w towards, const Surfaces_w* s) {
  realw density = splat_w(R(0.0)), area[AREA_ITEMS];
  light_reals_w(scene, at, AREA_ITEMS, area);
  switch (at->row[LIGHT_AREA]) {
#define AREA(name, count)                                              \
  case AREA_##name: {                                                  \
    realw reals[count];                                                \
    item_row_w(scene, at, splat_int_w(0), (count), reals);             \
    density = name##_density_w(reals, area, from, towards, s->normal); \
    break;                                                             \
  }
#include "areas/areas.def"
#undef AREA
    default:
      break;
  }
  maskw is_lit = lt_w(area_rounding_w(s->position, from, found_reach_w(scene, at, s)), -dot3_w(s->normal, towards));
  return sel_w(is_lit, density, splat_w(R(0.0)));
}

FN FoundLight_w area_background_w(const Scene* scene, GLOBAL const int* row, real3w towards) {
  (void)scene;
  (void)row;
  (void)towards;
  return no_light_found_w();
}

#if HAS_LIGHT_PATHS
/// Directions are drawn in proportion to their cosine.
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
#endif
