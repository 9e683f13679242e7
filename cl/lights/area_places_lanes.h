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

FN AreaPoint_w area_point_of_w(const Scene* scene, GLOBAL const int* row, real3w from, int item, realw u, realw v) {
  GLOBAL const real* params = scene->shading + row[LIGHT_REALS];
  AreaPoint_w p;
  switch (row[LIGHT_AREA]) {
#define AREA(name, reals)                                                         \
  case AREA_##name:                                                               \
    p = name##_point_w(params + AREA_ITEMS + item * (reals), params, from, u, v); \
    p.reach = splat_w(name##_reach_w(params + AREA_ITEMS + item * (reals)));      \
    return p;
#include "areas/areas.def"
#undef AREA
    default:
      (void)params;
      (void)item;
      (void)u;
      (void)v;
      p.position = p.normal = from;
      p.density = p.reach = p.u = p.v = splat_w(R(0.0));
      return p;
  }
}

/// Item by item: the lanes that chose the same item are drawn together.
FN AreaPoint_w area_point_w(const Scene* scene, GLOBAL const int* row, real3w from, intw item, realw u, realw v) {
  AreaPoint_w p = area_point_of_w(scene, row, from, get_int_w(&item, 0), u, v);
  for (uint others = bits_w(nonzero_w(item - splat_int_w(get_int_w(&item, 0)))); others != 0u;) {
    int one = get_int_w(&item, first_bit(others));
    maskw of_one = ~nonzero_w(item - splat_int_w(one));
    AreaPoint_w other = area_point_of_w(scene, row, from, one, u, v);
    p.position = sel3_w(of_one, other.position, p.position);
    p.normal = sel3_w(of_one, other.normal, p.normal);
    p.density = sel_w(of_one, other.density, p.density);
    p.reach = sel_w(of_one, other.reach, p.reach);
    if (HAS_LIGHT_TEXTURE) {
      p.u = sel_w(of_one, other.u, p.u);
      p.v = sel_w(of_one, other.v, p.v);
    }
    others &= ~bits_w(of_one);
  }
  return p;
}

/// As places_rounding_w, of a place and the point that sees it. Shadow rays end this far before a surface, as rays
/// begin off one (hits/departure.h). A point that is not this far in front of the emitter's plane is not lit by it.
/// Otherwise a flat emitter would light itself, by a rounding error divided by the square of a distance of the same
/// size. reach: of the item. A place near the origin on an emitter that reaches far is rounded by that.
FN realw area_rounding_w(real3w position, real3w from, realw reach) {
  return max_w(places_rounding_w(position, from), splat_w(R(16.0) * real_roundoff()) * reach);
}

/// Of a place that a ray has found.
FN realw found_reach_w(const Scene* scene, GLOBAL const int* row, const Surfaces_w* s) {
  GLOBAL const real* params = scene->shading + row[LIGHT_REALS];
  // Among many items, all of them flat, the hit knows its own corners: its bound is 7/4 u of their reach.
  if (row[LIGHT_ITEMS] > 1) return splat_w(R(4.0) / (R(7.0) * real_roundoff())) * s->bound;
  switch (row[LIGHT_AREA]) {
#define AREA(name, reals) \
  case AREA_##name:       \
    return splat_w(name##_reach_w(params + AREA_ITEMS));
#include "areas/areas.def"
#undef AREA
    default:
      (void)params;
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
