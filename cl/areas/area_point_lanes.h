// SPDX-License-Identifier: MIT
// Places on a surface that emits, as seen from elsewhere. One width; no guard.

typedef struct {
  real3w position;
  real3w normal;  ///< Unit, on the side that emits.
  realw density;  ///< Per solid angle; 0: the back of the surface is seen.
  realw reach;    ///< Of the item that it is on (areas.def).
  realw u, v;     ///< What made the place; with the normal, name_uv knows its texture coordinates by them.
} AreaPoint_w;

/// The density, per solid angle, of a place drawn uniformly from the whole area.
FN realw uniform_density_w(PRIVATE const realw* area, real3w towards, real3w normal) {
  realw zero = splat_w(R(0.0)), square = dot3_w(towards, towards), facing = -dot3_w(normal, towards);
  realw density = area[AREA_INVERSE] * (square * sqrt_w(square)) / facing;
  return sel_w(lt_w(zero, facing), density, zero);
}

FN AreaPoint_w uniform_point_w(PRIVATE const realw* area, real3w from, real3w position, real3w normal, realw u,
                               realw v) {
  AreaPoint_w p;
  p.u = u;
  p.v = v;
  p.position = position;
  p.normal = normal;
  p.density = uniform_density_w(area, sub3_w(position, from), normal);
  return p;
}

/// A place on a flat area. item: a corner, two edges and the unit normal on the side that emits.
FN AreaPoint_w flat_point_w(PRIVATE const realw* item, PRIVATE const realw* area, real3w from, realw of_u, realw of_v) {
  real3w edge_u = real3_at_w(item + 3), edge_v = real3_at_w(item + 6);
  real3w position = add3_w(fma3_w(of_u, edge_u, scale3_w(of_v, edge_v)), real3_at_w(item));
  return uniform_point_w(area, from, position, real3_at_w(item + 9), of_u, of_v);
}

/// Of a flat area.
FN realw flat_reach_w(PRIVATE const realw* item) {
  return max3_w(abs3_w(real3_at_w(item))) +
         (max3_w(abs3_w(real3_at_w(item + 3))) + max3_w(abs3_w(real3_at_w(item + 6))));
}

/// Texture coordinates of places on flat items. uvs: six reals an item, those of the corner and what each edge adds.
FN Real2_w flat_uv_w(GLOBAL const real* uvs, intw item, const AreaPoint_w* p) {
  realw row[6];
  gather_row_w(uvs, item * 6, 6, row);
  Real2_w uv;
  uv.x = fma_w(p->v, row[4], fma_w(p->u, row[2], row[0]));
  uv.y = fma_w(p->v, row[5], fma_w(p->u, row[3], row[1]));
  return uv;
}
