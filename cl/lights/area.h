// SPDX-License-Identifier: MIT
// A surface that emits the same radiance everywhere and in every direction on one side. Parameters: scene/layout.h,
// AREA_...; a place on it is drawn by its own shape, items in proportion to their area.
#ifndef STRAHL_LIGHTS_AREA_H
#define STRAHL_LIGHTS_AREA_H

#include "areas/all.h"
#include "areas/area_point.h"
#include "lights/light_sample.h"
#include "samplers/sample_state.h"
#include "scene/scene.h"

/// The item that the bits draw; u: what is left of them, within (0, 1).
FN int area_item(const Scene* scene, GLOBAL const int* row, uint bits, real* u) {
  uint items = (uint)row[LIGHT_ITEMS];
  *u = random_between(bits);
  if (items == 1u) return 0;
  uint item = high_product(bits, items), rest = bits * items;
  GLOBAL const int* choice = scene->index + row[LIGHT_CHOICE] + (int)item * CHOICE_INTS;
  uint limit = (uint)choice[CHOICE_LIMIT];
  int is_kept = rest < limit;
  real width = is_kept ? (real)limit : R(0x1p+32) - (real)limit;
  real share = ((real)(is_kept ? rest : rest - limit) + R(0.5)) / width;
  *u = share < R(1.0) ? share : R(1.0) - real_roundoff();
  return is_kept ? (int)item : choice[CHOICE_OTHER];
}

FN AreaPoint area_point(const Scene* scene, GLOBAL const int* row, real3 from, int item, real u, real v) {
  GLOBAL const real* params = scene->shading + row[LIGHT_REALS];
  AreaPoint none;
  switch (row[LIGHT_AREA]) {
#define AREA(name, reals) \
  case AREA_##name:       \
    return name##_point(params + AREA_ITEMS + item * (reals), params, from, u, v);
#include "areas/areas.def"
#undef AREA
    default:
      (void)params;
      (void)item;
      (void)u;
      (void)v;
      none.position = none.normal = from;
      none.density = R(0.0);
      return none;
  }
}

/// What rounds, of a place and of where it is seen from, and of the t at which a ray meets it: ways end so far before a
/// surface, as rays begin off one (core/departure.h). And who is not that far before its plane is not lit by it: else a
/// flat emitter would light itself, by rounding over the square of a distance that may be as small.
FN real area_rounding(real3 position, real3 from) {
  return R(16.0) * real_roundoff() * (max3(abs3(position)) + max3(abs3(from)));
}

FN LightSample area_sample(const Scene* scene, GLOBAL const int* row, real3 from, Random2 numbers) {
  real u;
  int item = area_item(scene, row, numbers.x, &u);
  AreaPoint p = area_point(scene, row, from, item, u, random_between(numbers.y));
  real bound = area_rounding(p.position, from);
  LightSample s;
  s.towards = sub3(p.position, from);
  int is_lit = p.density > R(0.0) && -dot3(p.normal, s.towards) > bound;
#if TIER_FAST
  s.t_max = R(1.0) - t_min_past_epsilon(s.towards);
#else
  s.towards = fma3(bound, p.normal, s.towards);
  s.t_max = R(1.0);
#endif
  s.density = p.density;
  s.aim = row[LIGHT_FIRST_ID] < 0 ? -1 : row[LIGHT_FIRST_ID] + item;
  real zero = R(0.0);
  s.irradiance = vec3(zero, zero, zero);
  if (is_lit) s.irradiance = scale3(R(1.0) / p.density, load3(scene->shading + row[LIGHT_REALS] + AREA_RADIANCE));
  return s;
}

FN real area_density(const Scene* scene, GLOBAL const int* row, real3 from, const Surface* s, real3 d) {
  GLOBAL const real* params = scene->shading + row[LIGHT_REALS];
  real3 towards = sub3(s->position, from);
  (void)d;
  if (!(-dot3(s->normal, towards) > area_rounding(s->position, from))) return R(0.0);
  switch (row[LIGHT_AREA]) {
#define AREA(name, reals) \
  case AREA_##name:       \
    return name##_density(params + AREA_ITEMS, params, from, towards, s->normal);
#include "areas/areas.def"
#undef AREA
    default:
      (void)params;
      return R(0.0);
  }
}

FN real3 area_background(GLOBAL const real* params) {
  (void)params;
  return vec3(R(0.0), R(0.0), R(0.0));
}

#endif
