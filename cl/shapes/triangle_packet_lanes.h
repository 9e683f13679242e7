// SPDX-License-Identifier: MIT
// LANES rays against one triangle at a time of a block: triangle_lanes.h with the roles exchanged, the same operations.
// One width; no guard.

/// Triangles of a block that some ray may meet.
FN uint LANED(may_meet_triangles)(const LANED(Packet) * p, GLOBAL const real* block, GLOBAL const int* ids) {
  LANED(Real3) lo, hi, near, far;
  realw a = load_w(block), b = load_w(block + 3 * LANES), c = load_w(block + 6 * LANES);
  lo.x = min_w(c, min_w(b, a));
  hi.x = max_w(c, max_w(b, a));
  a = load_w(block + LANES), b = load_w(block + 4 * LANES), c = load_w(block + 7 * LANES);
  lo.y = min_w(c, min_w(b, a));
  hi.y = max_w(c, max_w(b, a));
  a = load_w(block + 2 * LANES), b = load_w(block + 5 * LANES), c = load_w(block + 8 * LANES);
  lo.z = min_w(c, min_w(b, a));
  hi.z = max_w(c, max_w(b, a));
  near.x = p->near_x == 0 ? lo.x : hi.x;
  far.x = p->near_x == 0 ? hi.x : lo.x;
  near.y = p->near_y == 2 ? lo.y : hi.y;
  far.y = p->near_y == 2 ? hi.y : lo.y;
  near.z = p->near_z == 4 ? lo.z : hi.z;
  far.z = p->near_z == 4 ? hi.z : lo.z;
  real t[LANES];
  return LANED(may_meet)(p, near, far, t) & bits_w(nonzero_w(load_int_w(ids) - splat_int_w(-1)));
}

#if TIER_FAST
FN void LANED(triangle_packet)(const Scene* scene, LANED(Packet) * p, GLOBAL const real* block, GLOBAL const int* ids,
                               int slot, int kind, maskw active) {
  (void)scene;
  for (uint prims = LANED(may_meet_triangles)(p, block, ids); prims != 0u; prims &= prims - 1u) {
    int i = first_bit(prims);
    GLOBAL const real *a = block + i, *b = a + 3 * LANES, *c = a + 6 * LANES;
    realw ax = splat_w(a[0]), ay = splat_w(a[LANES]), az = splat_w(a[2 * LANES]);
    realw ex = splat_w(b[0] - a[0]), ey = splat_w(b[LANES] - a[LANES]), ez = splat_w(b[2 * LANES] - a[2 * LANES]);
    realw fx = splat_w(c[0] - a[0]), fy = splat_w(c[LANES] - a[LANES]), fz = splat_w(c[2 * LANES] - a[2 * LANES]);
    realw dx = p->d.x, dy = p->d.y, dz = p->d.z;
    realw sx = p->o.x - ax, sy = p->o.y - ay, sz = p->o.z - az;
    realw px = dy * fz - dz * fy, py = dz * fx - dx * fz, pz = dx * fy - dy * fx;
    realw qx = sy * ez - sz * ey, qy = sz * ex - sx * ez, qz = sx * ey - sy * ex;
    realw inverse = splat_w(R(1.0)) / (ex * px + ey * py + ez * pz);
    realw u = inverse * (sx * px + sy * py + sz * pz), v = inverse * (dx * qx + dy * qy + dz * qz);
    realw t = inverse * (fx * qx + fy * qy + fz * qz), zero = splat_w(R(0.0));
    maskw hit =
        active & lt_w(zero, u) & lt_w(zero, v) & lt_w(u + v, splat_w(R(1.0))) & le_w(p->t_min, t) & le_w(t, p->t);
    if (any_w(hit)) LANED(packet_take)(p, hit, t, splat_int_w(ids[i]), splat_int_w(kind), splat_int_w(slot + i));
  }
}
#else
/// planes: x, y, z of one vertex, LANES apart.
FN LANED(ShearedVertex)
    LANED(shear_for_each)(const LANED(Packet) * p, realw ox, realw oy, realw oz, GLOBAL const real* planes) {
  LANED(ShearedVertex) v;
  realw x = splat_w(planes[p->kx * LANES]) - ox, y = splat_w(planes[p->ky * LANES]) - oy;
  v.z = splat_w(planes[p->kz * LANES]) - oz;
  v.x = fma_w(-p->shear.x, v.z, x);
  v.y = fma_w(-p->shear.y, v.z, y);
  return v;
}

FN void LANED(triangle_packet)(const Scene* scene, LANED(Packet) * p, GLOBAL const real* block, GLOBAL const int* ids,
                               int slot, int kind, maskw active) {
  (void)scene;
  realw zero = splat_w(R(0.0));
  realw ox = LANED(component_w)(&p->o, p->kx), oy = LANED(component_w)(&p->o, p->ky);
  realw oz = LANED(component_w)(&p->o, p->kz);
  for (uint prims = LANED(may_meet_triangles)(p, block, ids); prims != 0u; prims &= prims - 1u) {
    int i = first_bit(prims);
    LANED(ShearedVertex) a = LANED(shear_for_each)(p, ox, oy, oz, block + i);
    LANED(ShearedVertex) b = LANED(shear_for_each)(p, ox, oy, oz, block + 3 * LANES + i);
    LANED(ShearedVertex) c = LANED(shear_for_each)(p, ox, oy, oz, block + 6 * LANES + i);
    realw ea = LANED(edge_function)(b, c), eb = LANED(edge_function)(c, a), ec = LANED(edge_function)(a, b);
    realw sum = ea + eb + ec;
    maskw hit = active & ~(LANED(signs_differ)(ea, eb, ec) | eq_w(sum, zero));
    if (p->has_left) hit = hit & ~LANED(packet_left)(p, ids[i]);
    if (!any_w(hit)) continue;
    realw z_min = min_w(c.z, min_w(b.z, a.z)), z_max = max_w(c.z, max_w(b.z, a.z));
    realw weighted = fma_w(ec, c.z, fma_w(eb, b.z, ea * a.z));
#if TIER_ROBUST
    // in_range_roughly of polygon_robust_lanes.h.
    realw scale = p->shear.z / sum, t = weighted * scale;
    realw z = max_w(abs_w(z_min), abs_w(z_max));
    realw l = max_w(LANED(aside_of)(c), max_w(LANED(aside_of)(b), LANED(aside_of)(a)));
    realw turned = l * (z_max - z_min) * abs_w(scale);
    realw spare = fma_w(splat_w(R(0x1p-17)) * (l + z), turned, splat_w(R(0x1p-20)) * z);
    realw one = z_min * p->shear.z, other = z_max * p->shear.z, first = min_w(one, other), last = max_w(one, other);
    // As in_range_roughly has it.
    realw area = abs_w(sum);
    maskw is_clear = lt_w(turned, splat_w(R(256.0))) & lt_w(splat_w(R(0x1p-18)) * l * l, area) &
                     lt_w(splat_w(R(0x1p-100)), area) & lt_w(area * (l + z), splat_w(R(0x1p+120)));
    realw least = sel_w(is_clear, max_w(t - spare, first), first);
    realw most = sel_w(is_clear, min_w(t + spare, last), splat_w(REAL_MAX));
    hit = hit & ~(lt_w(p->bound, least) | lt_w(most, p->t_min));
#else
    realw t = weighted / sum * p->shear.z;
#if REAL_BITS == 64
    LANED(Interval) slabs;
    slabs.enter = splat_w(-REAL_MAX);
    slabs.leave = splat_w(REAL_MAX);
    real lo[3], hi[3];
    for (int axis = 0; axis < 3; ++axis) {
      real pa = block[axis * LANES + i], pb = block[(3 + axis) * LANES + i], pc = block[(6 + axis) * LANES + i];
      real least = pb < pa ? pb : pa, most = pa < pb ? pb : pa;
      lo[axis] = pc < least ? pc : least;
      hi[axis] = most < pc ? pc : most;
    }
    int x = p->near_x == 0, y = p->near_y == 2, zz = p->near_z == 4;
    slabs = LANED(clip_each)(slabs, x ? lo[0] : hi[0], x ? hi[0] : lo[0], p->o.x, p->inv.x, p->slack.x);
    slabs = LANED(clip_each)(slabs, y ? lo[1] : hi[1], y ? hi[1] : lo[1], p->o.y, p->inv.y, p->slack.y);
    slabs = LANED(clip_each)(slabs, zz ? lo[2] : hi[2], zz ? hi[2] : lo[2], p->o.z, p->inv.z, p->slack.z);
    t = sel_w(lt_w(t, slabs.enter), slabs.enter, t);
    t = sel_w(lt_w(slabs.leave, t), slabs.leave, t);
#endif
    realw one = z_min * p->shear.z, other = z_max * p->shear.z;
    realw least_t = min_w(one, other), most_t = max_w(one, other);
    t = sel_w(lt_w(t, least_t), least_t, t);
    t = sel_w(lt_w(most_t, t), most_t, t);
    hit = hit & le_w(p->t_min, t) & le_w(t, p->t);
#endif
    maskw on_edge = hit & (eq_w(ea, zero) | eq_w(eb, zero) | eq_w(ec, zero));
    if (any_w(on_edge))
      hit = hit & ~(on_edge & LANED(signs_differ)(LANED(resolved_edge)(ea, b, c), LANED(resolved_edge)(eb, c, a),
                                                  LANED(resolved_edge)(ec, a, b)));
    if (!any_w(hit)) continue;
#if TIER_ROBUST
    LANED(packet_put_off)(scene, p, hit, hit & le_w(p->t_min, least), t, least, most, ids[i], kind, slot + i);
#else
    LANED(packet_take)(p, hit, t, splat_int_w(ids[i]), splat_int_w(kind), splat_int_w(slot + i));
#endif
  }
}
#endif
