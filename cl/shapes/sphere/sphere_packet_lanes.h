// SPDX-License-Identifier: MIT
// LANES rays against one sphere at a time of a block: sphere_lanes.h with the roles exchanged, the same operations. One
// width; no guard.

#if TIER_FAST
/// The square of the largest distance of x from any ray's origin, along one axis.
FN realw farthest_square_w(realw x, Bounds_w b) {
  realw far = max_w(abs_w(x - splat_w(b.o_near)), abs_w(x - splat_w(b.o_far)));
  return far * far;
}
#endif

/// Spheres of a block that some ray may meet.
FN uint may_meet_spheres_w(const Packet_w* p, GLOBAL const real* block, GLOBAL const int* ids) {
  uint there = bits_w(nonzero_w(load_int_w(ids) - splat_int_w(-1)));
  if (!is_alike_w(p)) return there;
  realw r = load_w(block + 3 * LANES), cx = load_w(block), cy = load_w(block + LANES), cz = load_w(block + 2 * LANES);
#if TIER_FAST
  // The textbook's discriminant may be off by some 12 u of the square of the distance.
  realw ff = farthest_square_w(cx, p->x) + farthest_square_w(cy, p->y) + farthest_square_w(cz, p->z);
  r = sqrt_w(fma_w(r, r, splat_w(R(0x1p-20)) * ff));
#endif
  realw rx = p->near_x == 0 ? -r : r, ry = p->near_y == 2 ? -r : r, rz = p->near_z == 4 ? -r : r;
  real3w near, far;
  near.x = cx + rx;
  near.y = cy + ry;
  near.z = cz + rz;
  far.x = cx - rx;
  far.y = cy - ry;
  far.z = cz - rz;
  return there & may_meet_w(p, near, far);
}

#if TIER_COMPENSATED
/// The box around a sphere, lo_x, hi_x, lo_y, hi_y, lo_z, hi_z.
FN void sphere_box_w(GLOBAL const real* prim, PRIVATE real* box) {
  real r = prim[3 * LANES];
  for (int axis = 0; axis < 3; ++axis) {
    box[2 * axis] = prim[axis * LANES] - r;
    box[2 * axis + 1] = prim[axis * LANES] + r;
  }
}
#endif

#if TIER_ROBUST
/// The sphere that the lanes of `departed` have just left, at its other root, as in sphere_root.
SELDOM_FN void left_sphere_w(Packet_w* p, GLOBAL const real* prim, int id, int kind, int slot, maskw departed) {
  real x = prim[0], y = prim[LANES], z = prim[2 * LANES];
  ExactRays_w exact;
  exact_rays_w(p->rays, &exact);
  realw t = sphere_root_across_w(&exact, splat3_w(vec3(x, y, z)), departed);
  real box[6];
  sphere_box_w(prim, box);
  Interval_w slabs = box_interval_w(p, box);
  maskw hit = departed & lt_w(splat_w(R(0.0)), t) & le_w(slabs.enter, t) & le_w(t, slabs.leave);
  hit = hit & le_w(p->t_min, t) & le_w(t, p->t);
  if (any_w(hit)) packet_take_w(p, hit, t, splat_int_w(id), splat_int_w(kind), splat_int_w(slot));
}

/// A sphere that the lanes of `asked` may hit and have not left, at its exact t.
SELDOM_FN void exact_sphere_w(Packet_w* p, GLOBAL const real* prim, int id, int kind, int slot, maskw asked) {
  ExactRays_w exact;
  exact_rays_w(p->rays, &exact);
  maskw met;
  realw t = sphere_root_w(&exact, splat3_w(vec3(prim[0], prim[LANES], prim[2 * LANES])), splat_w(prim[3 * LANES]),
                          asked, &met);
  maskw hit = asked & met & le_w(p->t_min, t) & le_w(t, p->t);
  if (any_w(hit)) packet_take_w(p, hit, t, splat_int_w(id), splat_int_w(kind), splat_int_w(slot));
}
#endif

FN void sphere_packet_w(const Scene* scene, Packet_w* p, GLOBAL const real* block, GLOBAL const int* ids, int slot,
                        int kind, maskw active) {
  (void)scene;
  realw dx = p->d.x, dy = p->d.y, dz = p->d.z, zero = splat_w(R(0.0));
#if TIER_FAST
  realw a = dx * dx + dy * dy + dz * dz, scale = splat_w(R(0.5)) / a;
#elif !TIER_ROBUST
  realw a = fma_w(dz, dz, fma_w(dy, dy, dx * dx));
#endif
  for (uint prims = may_meet_spheres_w(p, block, ids); prims != 0u; prims &= prims - 1u) {
    int i = first_bit(prims);
    GLOBAL const real* prim = block + i;
    realw r = splat_w(prim[3 * LANES]), fx = p->o.x - splat_w(prim[0]), fy = p->o.y - splat_w(prim[LANES]);
    realw fz = p->o.z - splat_w(prim[2 * LANES]);
#if TIER_FAST
    realw b = splat_w(R(2.0)) * (fx * dx + fy * dy + fz * dz);
    realw c = fx * fx + fy * fy + fz * fz - r * r;
    realw discriminant = b * b - splat_w(R(4.0)) * a * c;
    maskw hit = active & le_w(zero, discriminant);
    if (!any_w(hit)) continue;
    realw root = sqrt_w(discriminant), near = (-b - root) * scale, far = (root - b) * scale;
    realw t = sel_w(le_w(p->t_min, near), near, far);
    hit = hit & le_w(p->t_min, t) & le_w(t, p->t) & nonzero_w(p->aim - splat_int_w(ids[i]));
    if (any_w(hit)) packet_take_w(p, hit, t, splat_int_w(ids[i]), splat_int_w(kind), splat_int_w(slot + i));
#elif TIER_ROBUST
    // sphere_in_reach of sphere_robust_lanes.h.
    realw tiny = splat_w(R(0x1p-120));
    realw b = fma_w(fz, dz, fma_w(fy, dy, fx * dx)), k = -b * p->dd_inverse;
    realw lx = fma_w(k, dx, fx), ly = fma_w(k, dy, fy), lz = fma_w(k, dz, fz);
    realw size = abs_w(fx) + abs_w(fy) + abs_w(fz);
    realw off = fma_w(splat_w(R(0x1p-19)), size, tiny), limit = r + off;
    realw apart = fma_w(lz, lz, fma_w(ly, ly, lx * lx)), reach = fma_w(r, p->t_per_length, off);
    maskw met =
        active & ~(lt_w(fma_w(limit, limit, tiny), apart) | lt_w(p->bound, k - reach) | lt_w(k + reach, p->t_min));
    maskw departed = none_w();
    if (p->has_departed) {
      departed = active & packet_departed_w(p, ids[i]);
      met = met & ~departed;
      departed = departed & ~(p->outward | lt_w(off, b));
      if (any_w(departed)) left_sphere_w(p, prim, ids[i], kind, slot + i, departed);
    }
    if (!any_w(met)) continue;

    // Those that the line passes through for certain: apart is off by less than 16 u |f| r and 4 u of r^2, or if that
    // does not do, from f - c as it is, by 8 u of r^2.
    realw rr = r * r, inside = rr - apart;
    maskw sure = met & le_w(splat_w(R(0x1p-14)) * r * (size + r), inside);
    if (any_w(met & ~sure & lt_w(zero, inside))) {
      dw3_w f =
          two_difference3_w(p->o.x, p->o.y, p->o.z, splat_w(prim[0]), splat_w(prim[LANES]), splat_w(prim[2 * LANES]));
      lx = lx + f.x.lo;
      ly = ly + f.y.lo;
      lz = lz + f.z.lo;
      inside = rr - fma_w(lz, lz, fma_w(ly, ly, lx * lx));
      sure = met & le_w(splat_w(R(0x1p-6)) * rr, inside);
    }
    realw t, about;
    sure = sure & sphere_approximately_w(p->t_min, p->dd_inverse, k, off, inside, &t, &about);
    met = met & ~sure;
    sure = sure & ~lt_w(p->bound, t - about);
    if (any_w(sure))
      packet_put_off_w(scene, p, sure, sure, t, t - about, t + about, splat_int_w(ids[i]), kind, splat_int_w(slot + i));
    if (any_w(met)) exact_sphere_w(p, prim, ids[i], kind, slot + i, met);
#else
    realw b = fma_w(fz, dz, fma_w(fy, dy, fx * dx));
    realw k = b / a;
    realw lx = fma_w(-k, dx, fx), ly = fma_w(-k, dy, fy), lz = fma_w(-k, dz, fz);
    realw r2 = r * r;
    realw d = r2 - fma_w(lz, lz, fma_w(ly, ly, lx * lx));
    maskw hit = le_w(zero, d), departed = none_w();
    if (p->has_departed) departed = packet_departed_w(p, ids[i]);
    if (!any_w(active & (hit | departed))) continue;
    realw root = sqrt_w(a * max_w(d, zero));
    realw q = -b - sel_w(lt_w(b, zero), -root, root);
    realw c = fma_w(fz, fz, fma_w(fy, fy, fx * fx)) - r2;
    realw t0 = q / a, t1 = c / q;
    realw near = sel_w(lt_w(t1, t0), t1, t0), far = sel_w(lt_w(t1, t0), t0, t1);
    realw t = sel_w(le_w(p->t_min, near), near, far);
    realw other = splat_w(-R(2.0)) * k;
    t = sel_w(departed, other, t);
    hit = (hit & ~departed) | (departed & ~p->outward & lt_w(zero, other));
#if REAL_BITS == 64
    real box[6];
    sphere_box_w(prim, box);
    realw within = clamped_to_box_w(p, t, box);
    hit = hit & (~departed | eq_w(within, t));
    t = within;
#endif
    hit = hit & active & le_w(p->t_min, t) & le_w(t, p->t);
    if (any_w(hit)) packet_take_w(p, hit, t, splat_int_w(ids[i]), splat_int_w(kind), splat_int_w(slot + i));
#endif
  }
}
