// SPDX-License-Identifier: MIT
// Places on surfaces that emit, of lights area and directionalarea: items are drawn in proportion to their area, and
// the shape's own file draws a place on one. Parameters: scene/layout.h, AREA_.... One width; no guard.
#include "areas/area_point_lanes.h"
#include "areas/all_lanes.h"

/// The items that the numbers choose, each with the probability of its share of the area, to items / 2^32.
FN intw area_item_w(const Scene* scene, GLOBAL const int* row, uintw numbers) {
  uint items = (uint)row[LIGHT_ITEMS];
  if (items == 1u) return splat_int_w(0);
  return chosen_item_w(scene->index + row[LIGHT_CHOICE], splat_int_w(0), items, numbers);
}

/// What the lanes' lights have for their items: reals of each.
FN void item_row_w(const Scene* scene, const LightRows_w* at, intw item, int count, PRIVATE realw* reals) {
  intw places = light_entry_w(scene, at, LIGHT_REALS) + splat_int_w(AREA_ITEMS) + item * splat_int_w(count);
  int is_one = at->is_one && !any_w(nonzero_w(item - splat_int_w(get_int_w(&item, 0))));
  shading_row_w(scene, places, is_one, count, reals);
}

/// area: the lights' parameters before their items.
FN AreaPoint_w area_point_w(const Scene* scene, const LightRows_w* at, PRIVATE const realw* area, real3w from,
                            intw item, realw u, realw v) {
  AreaPoint_w p;
  switch (at->row[LIGHT_AREA]) {
#define AREA(name, count)                        \
  case AREA_##name: {                            \
    realw reals[count];                          \
    item_row_w(scene, at, item, (count), reals); \
    p = name##_point_w(reals, area, from, u, v); \
    p.reach = name##_reach_w(reals);             \
    return p;                                    \
  }
#include "areas/areas.def"
#undef AREA
    default:
      (void)scene;
      (void)area;
      (void)item;
      (void)u;
      (void)v;
      p.position = p.normal = from;
      p.density = p.reach = p.u = p.v = splat_w(R(0.0));
      return p;
  }
}

/// As places_rounding_w, of a place and the point that sees it. Shadow rays end this far before a surface, as rays
/// begin off one (hits/departure.h). A point that is not this far in front of the emitter's plane is not lit by it.
/// Otherwise a flat emitter would light itself, by a rounding error divided by the square of a distance of the same
/// size. reach: of the item. A place near the origin on an emitter that reaches far is rounded by that.
FN realw area_rounding_w(real3w position, real3w from, realw reach) {
  return max_w(places_rounding_w(position, from), splat_w(R(16.0) * real_roundoff()) * reach);
}

/// Of a place that a ray has found.
FN realw found_reach_w(const Scene* scene, const LightRows_w* at, const Surfaces_w* s) {
  // Among many items, all of them flat, the hit knows its own corners: its bound is 7/4 u of their reach.
  if (at->row[LIGHT_ITEMS] > 1) return splat_w(R(4.0) / (R(7.0) * real_roundoff())) * s->bound;
  switch (at->row[LIGHT_AREA]) {
#define AREA(name, count)                                  \
  case AREA_##name: {                                      \
    realw reals[count];                                    \
    item_row_w(scene, at, splat_int_w(0), (count), reals); \
    return name##_reach_w(reals);                          \
  }
#include "areas/areas.def"
#undef AREA
    default:
      (void)scene;
      return splat_w(R(0.0));
  }
}

/// The texture of a light that has one, at a place on it.
FN real3w area_texture_w(const Scene* scene, GLOBAL const int* row, intw item, const AreaPoint_w* p) {
  GLOBAL const real* uvs = scene->shading + row[LIGHT_UVS];
  real side = scene->shading[row[LIGHT_REALS] + AREA_SIDE];
  Real2_w uv;
  uv.x = uv.y = splat_w(R(0.0));
  switch (row[LIGHT_AREA]) {
#define AREA(name, reals)                 \
  case AREA_##name:                       \
    uv = name##_uv_w(uvs, item, p, side); \
    break;
#include "areas/areas.def"
#undef AREA
    default:
      (void)uvs;
      (void)side;
      (void)item;
      (void)p;
      break;
  }
  TexturePlace_w at = texture_at_w(uv.x, uv.y);
  if (HAS_MESH_ATTRIBUTE) {
    // A mesh with attributes has one part, whose items are its primitives.
    at.own_u = p->u;
    at.own_v = p->v;
    at.part = splat_int_w(row[LIGHT_PART]);
    at.primitive = item;
  }
  return texture_value_w(scene, row[LIGHT_TEXTURE], &at);
}
