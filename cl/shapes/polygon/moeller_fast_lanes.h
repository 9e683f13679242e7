// SPDX-License-Identifier: MIT
// Solves o + t d = a + u e + v f for LANES pairs of edges: T. Moeller, B. Trumbore, "Fast, Minimum Storage Ray-Triangle
// Intersection", JGT 2(1), 1997. Leaks at shared edges and vertices. One width; no guard.

typedef struct {
  realw t, u, v;
} Moeller_w;

/// a, b, c: three planes of LANES reals each; e = b - a, f = c - a. A parallel ray gives infinities or NaN.
FN Moeller_w moeller_w(const Ray* ray, GLOBAL const real* a, GLOBAL const real* b, GLOBAL const real* c) {
  realw ax = load_w(a), ay = load_w(a + LANES), az = load_w(a + 2 * LANES);
  realw ex = load_w(b) - ax, ey = load_w(b + LANES) - ay, ez = load_w(b + 2 * LANES) - az;
  realw fx = load_w(c) - ax, fy = load_w(c + LANES) - ay, fz = load_w(c + 2 * LANES) - az;
  realw dx = splat_w(ray->d.x), dy = splat_w(ray->d.y), dz = splat_w(ray->d.z);
  realw sx = splat_w(ray->o.x) - ax, sy = splat_w(ray->o.y) - ay, sz = splat_w(ray->o.z) - az;
  realw px = dy * fz - dz * fy, py = dz * fx - dx * fz, pz = dx * fy - dy * fx;
  realw qx = sy * ez - sz * ey, qy = sz * ex - sx * ez, qz = sx * ey - sy * ex;
  realw inverse = splat_w(R(1.0)) / (ex * px + ey * py + ez * pz);
  Moeller_w m;
  m.u = inverse * (sx * px + sy * py + sz * pz);
  m.v = inverse * (dx * qx + dy * qy + dz * qz);
  m.t = inverse * (fx * qx + fy * qy + fz * qz);
  return m;
}
