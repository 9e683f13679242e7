// SPDX-License-Identifier: MIT
// Hits of a packet that are put off, robust tier: a primitive is found to be hit for certain, at a t that is known but
// for its last digits. Each ray keeps the nearest such hit, as long as no other comes too near to it to tell which is
// the nearer; only what is left in the end is decided exactly, LANES rays at a time, each with a primitive of its own.
// One width; no guard.

/// t of a triangle a lane, as triangle_t has it; ok: lanes where that need not ask polygon_t.
FN realw LANED(triangle_t_each)(const LANED(Packet) * p, PRIVATE const real* corners, maskw* ok) {
  realw ax = read_w(corners), ay = read_w(corners + LANES), az = read_w(corners + 2 * LANES);
  realw ex = read_w(corners + 3 * LANES) - ax, ey = read_w(corners + 4 * LANES) - ay;
  realw ez = read_w(corners + 5 * LANES) - az, fx = read_w(corners + 6 * LANES) - ax;
  realw fy = read_w(corners + 7 * LANES) - ay, fz = read_w(corners + 8 * LANES) - az;
  realw nx = difference_of_products_w(ey, fz, ez, fy), ny = difference_of_products_w(ez, fx, ex, fz);
  realw nz = difference_of_products_w(ex, fy, ey, fx);
  dw3_w g = two_difference3_w(ax, ay, az, p->o.x, p->o.y, p->o.z);
  realw rough = p->rough;
  realw x = fma_w(-rough, p->d.x, g.x.hi) + g.x.lo, y = fma_w(-rough, p->d.y, g.y.hi) + g.y.lo;
  realw z = fma_w(-rough, p->d.z, g.z.hi) + g.z.lo;
  realw n_d = fma_w(nz, p->d.z, fma_w(ny, p->d.y, nx * p->d.x));
  realw t = fma_w(fma_w(nz, z, fma_w(ny, y, nx * x)), splat_w(R(1.0)) / n_d, rough);
  realw edges = (abs_w(ex) + abs_w(ey) + abs_w(ez)) + (abs_w(fx) + abs_w(fy) + abs_w(fz));
  *ok = le_w(splat_w(R(4.0)) * edges * (abs_w(nx) + abs_w(ny) + abs_w(nz)), abs_w(t * n_d));
  return t;
}

FN dw_w LANED(plus_along_each)(dw_w x, realw t, realw d) {
  dw_w along = two_prod_w(t, d), s = two_sum_w(x.hi, along.hi);
  s.lo = s.lo + (along.lo + x.lo);
  return s;
}

FN dw_w LANED(square_of_each)(dw_w x) {
  dw_w square = two_prod_w(x.hi, x.hi);
  square.lo = fma_w(x.hi + x.hi, x.lo, square.lo);
  return square;
}

/// sphere_root_near of a sphere a lane.
FN realw LANED(sphere_root_each)(const LANED(Packet) * p, const dw3_w* f, realw r, realw t, maskw* ok) {
  dw_w x = LANED(plus_along_each)(f->x, t, p->d.x), y = LANED(plus_along_each)(f->y, t, p->d.y);
  dw_w z = LANED(plus_along_each)(f->z, t, p->d.z);
  realw q_d = fma_w(z.hi, p->d.z, fma_w(y.hi, p->d.y, x.hi * p->d.x)), inverse = splat_w(R(1.0)) / q_d;
  dw_w xx = LANED(square_of_each)(x), yy = LANED(square_of_each)(y), zz = LANED(square_of_each)(z);
  dw_w rr = two_prod_w(r, r), one = two_sum_w(xx.hi, -rr.hi), other = two_sum_w(yy.hi, zz.hi);
  dw_w sum = two_sum_w(one.hi, other.hi);
  realw rest = (one.lo + other.lo) + ((xx.lo + yy.lo) + (zz.lo - rr.lo)), far_off = t * t * p->dd;
  *ok = le_w(splat_w(R(0x1p-6)) * rr.hi * p->dd, q_d * q_d) & le_w(splat_w(R(0x1p-18)) * rr.hi, far_off) &
        le_w(far_off, splat_w(R(0x1p+38)) * rr.hi);
  return fma_w(splat_w(-R(0.5)) * (sum.hi + (sum.lo + rest)), inverse, t);
}

/// t of a sphere a lane, as sphere_is_plain has it; ok: lanes where that is 1.
FN realw LANED(sphere_t_each)(const LANED(Packet) * p, PRIVATE const real* spheres, maskw which, maskw* ok) {
  dw3_w f =
      two_difference3_w(p->o.x, p->o.y, p->o.z, read_w(spheres), read_w(spheres + LANES), read_w(spheres + 2 * LANES));
  realw r = read_w(spheres + 3 * LANES), dx = p->d.x, dy = p->d.y, dz = p->d.z;
  realw k = -fma_w(f.z.hi, dz, fma_w(f.y.hi, dy, f.x.hi * dx)) * p->dd_inverse;
  realw x = fma_w(k, dx, f.x.hi) + f.x.lo, y = fma_w(k, dy, f.y.hi) + f.y.lo;
  realw z = fma_w(k, dz, f.z.hi) + f.z.lo, pp = fma_w(z, z, fma_w(y, y, x * x)), rr = r * r;
  realw e = fma_w(z, dz, fma_w(y, dy, x * dx)), inside = fma_w(e * e, p->dd_inverse, rr - pp);
  *ok = le_w(splat_w(R(0x1p-6)) * rr, inside);
  realw root = sqrt_w(inside * p->dd_inverse), middle = e * p->dd_inverse, slope = root * p->dd;
  realw near = k - (middle + root), far = k - (middle - root), least = splat_w(R(16.0)) * rr;
  realw t = sel_w(le_w(p->t_min, near), near, far);
  maskw sure =
      le_w(least, abs_w(near) * slope) & le_w(least, abs_w(t) * slope) & le_w(splat_w(R(0x1p-20)) * abs_w(k), r);
  if (!any_w(which & *ok & ~sure)) return t;
  maskw fine;
  realw refined = LANED(sphere_root_each)(p, &f, r, near, &fine);
  maskw is_far = fine & lt_w(refined, p->t_min);
  if (any_w(which & is_far)) {
    maskw far_fine;
    realw farther = LANED(sphere_root_each)(p, &f, r, far, &far_fine);
    refined = sel_w(is_far, farther, refined);
    fine = fine & (~is_far | far_fine);
  }
  *ok = *ok & (sure | fine);
  return sel_w(sure, t, refined);
}

/// t of the sphere that ray `lane` has hit for certain.
FN real LANED(sphere_t_one)(const Ray* ray, GLOBAL const real* prim) {
  Exact3 f = exact_difference(ray->o, vec3(prim[0], prim[LANES], prim[2 * LANES]));
  SphereRoots roots = sphere_roots(ray, f, prim[3 * LANES]);
  return ray->t_min <= roots.near ? roots.near : roots.far;
}

/// Decides what was put off of one kind.
FN void LANED(settle_kind)(const Scene* scene, LANED(Packet) * p, int kind, int body, int planes) {
  maskw which = ~nonzero_w(p->rough_kind - splat_int_w(kind));
  uint lanes = bits_w(which);
  if (lanes == 0u) return;
  GLOBAL const real* geometry = scene->geometry + scene_shape_row(scene, kind)[SHAPE_GEOMETRY];
  real each[9 * LANES];
  int slots[LANES];
  store_int_w(p->rough_slot, slots);
  int first = first_bit(lanes);
  maskw ok = none_w();
  realw t = p->rough;
  if (body != PACKET_BODY_PARALLELOGRAM) {
    for (int i = 0; i < LANES; ++i) {
      int slot = slots[(lanes >> i & 1u) != 0u ? i : first];
      GLOBAL const real* prim = geometry + (ulong)(slot / LANES) * (ulong)(planes * LANES) + slot % LANES;
      for (int k = 0; k < planes; ++k) each[k * LANES + i] = prim[k * LANES];
    }
    t = body == PACKET_BODY_TRIANGLE ? LANED(triangle_t_each)(p, each, &ok) : LANED(sphere_t_each)(p, each, which, &ok);
  }
  uint others = bits_w(which & ~ok);
  if (others != 0u) {
    real ts[LANES], rough[LANES];
    store_w(t, ts);
    store_w(p->rough, rough);
    for (; others != 0u; others &= others - 1u) {
      int i = first_bit(others), slot = slots[i];
      GLOBAL const real* prim = geometry + (ulong)(slot / LANES) * (ulong)(planes * LANES) + slot % LANES;
      Ray ray = LANED(packet_ray)(p, i);
      if (body == PACKET_BODY_SPHERE)
        ts[i] = LANED(sphere_t_one)(&ray, prim);
      else
        ts[i] = polygon_exact_t(&ray, rough[i], prim, body == PACKET_BODY_TRIANGLE ? 3 : 4, LANES);
    }
    t = read_w(ts);
  }
  LANED(packet_take)(p, which & le_w(p->t_min, t), t, p->rough_id, p->rough_kind, p->rough_slot);
  p->rough_kind = sel_int_w(which, splat_int_w(-1), p->rough_kind);
}

SELDOM_FN void LANED(packet_settle)(const Scene* scene, LANED(Packet) * p) {
  (void)scene;  // A scene of other kinds.
  (void)p;
#define SHAPE(name, planes)                          \
  if (LANED(PACKET_BODY_##name) < PACKET_BODY_PLANE) \
    LANED(settle_kind)(scene, p, SHAPE_##name, LANED(PACKET_BODY_##name), planes);
#include "shapes/shapes.def"
#undef SHAPE
}

/// What is left in the end. Where t may be rough, polygons that are the nearest for certain stay put off: t is not
/// below what it will be.
FN void LANED(packet_finish)(const Scene* scene, LANED(Packet) * p, int may_be_rough) {
  if (may_be_rough) {
    maskw is_flat = none_w();
#define SHAPE(name, planes)                                                                                        \
  if (LANED(PACKET_BODY_##name) == PACKET_BODY_TRIANGLE || LANED(PACKET_BODY_##name) == PACKET_BODY_PARALLELOGRAM) \
    is_flat = is_flat | ~nonzero_w(p->rough_kind - splat_int_w(SHAPE_##name));
#include "shapes/shapes.def"
#undef SHAPE
    maskw sure = is_flat & lt_w(p->bound, p->t);
    p->t = sel_w(sure, p->bound, p->t);
    p->id = sel_int_w(sure, p->rough_id, p->id);
    p->kind = sel_int_w(sure, p->rough_kind, p->kind);
    p->slot = sel_int_w(sure, p->rough_slot, p->slot);
    p->rough_kind = sel_int_w(sure, splat_int_w(-1), p->rough_kind);
    if (HAS_INSTANCES) p->instance = sel_int_w(sure, splat_int_w(-1), p->instance);
  }
  if (any_w(~lt_int_w(p->rough_kind, splat_int_w(0)))) LANED(packet_settle)(scene, p);
}

/// Puts off: hit at `rough`, for certain within least ... most; `sure` lanes of them also after t_min.
FN void LANED(packet_put_off)(const Scene* scene, LANED(Packet) * p, maskw hit, maskw sure, realw rough, realw least,
                              realw most, intw id, int kind, intw slot) {
  if (p->stop_at_first) {
    maskw met = hit & sure & lt_w(most, p->bound);
    p->kind = sel_int_w(met, splat_int_w(kind), p->kind);
    p->t = sel_w(met, splat_w(-REAL_MAX), p->t);
    p->bound = sel_w(met, splat_w(-REAL_MAX), p->bound);
    hit = hit & ~met;
    if (!any_w(hit)) return;
  }
  maskw is_held = ~lt_int_w(p->rough_kind, splat_int_w(0)), unsure = hit & ~sure;
  // What is held comes after the new one for certain, or gives way to an exact answer.
  if (any_w(unsure | (hit & is_held & ~lt_w(most, p->rough_least)))) LANED(packet_settle)(scene, p);
  p->rough = sel_w(hit, rough, p->rough);
  p->rough_least = sel_w(hit, least, p->rough_least);
  p->rough_id = sel_int_w(hit, id, p->rough_id);
  p->rough_kind = sel_int_w(hit, splat_int_w(kind), p->rough_kind);
  p->rough_slot = sel_int_w(hit, slot, p->rough_slot);
  p->bound = sel_w(hit & sure & lt_w(most, p->bound), most, p->bound);
  if (any_w(unsure)) LANED(packet_settle)(scene, p);
}
