// SPDX-License-Identifier: MIT
// Open cylinder: foot, axis (as long as it is), two perpendicular radii.

FN AreaPoint_w cylinder_point_w(PRIVATE const realw* item, PRIVATE const realw* area, real3w from, realw u, realw v) {
  SinCos_w turned = sincos_turns_w(u);
  real3w outward = fma3_w(turned.cosine, real3_at_w(item + 6), scale3_w(turned.sine, real3_at_w(item + 9)));
  real3w position = add3_w(fma3_w(v, real3_at_w(item + 3), outward), real3_at_w(item));
  return uniform_point_w(area, from, position, normalize3_w(scale3_w(area[AREA_SIDE], outward)), u, v);
}

FN realw cylinder_reach_w(PRIVATE const realw* item) {
  return flat_reach_w(item) + max3_w(abs3_w(real3_at_w(item + 9)));
}

FN realw cylinder_density_w(PRIVATE const realw* item, PRIVATE const realw* area, real3w from, real3w towards,
                            real3w normal) {
  (void)item;
  (void)from;
  return uniform_density_w(area, towards, normal);
}

FN Real2_w cylinder_uv_w(GLOBAL const real* uvs, intw item, const AreaPoint_w* p, real side) {
  (void)uvs;
  (void)item;
  (void)side;
  Real2_w uv;
  uv.x = p->u;
  uv.y = p->v;
  return uv;
}
