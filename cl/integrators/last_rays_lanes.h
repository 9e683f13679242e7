// SPDX-License-Identifier: MIT
// The last ray of a path only looks for emission. It is followed only where it meets one of the boxes around all that
// emits, which are larger than roundings (src/packing/path_lengths.cpp), so the picture does not depend on it. One
// width; no guard.

/// One axis of a box, from lo - by to hi + by.
FN Interval_w clip_last_w(Interval_w t, real lo, real hi, realw by, realw o, realw inv) {
  realw a = (splat_w(lo) - by - o) * inv, b = (splat_w(hi) + by - o) * inv;
  // Where a NaN comes from a ray in the plane of a face, the other plane says nothing either.
  maskw is_known = ~nan_w(a) & ~nan_w(b);
  t.enter = max_w(sel_w(is_known, min_w(b, a), t.enter), t.enter);
  t.leave = min_w(sel_w(is_known, max_w(b, a), t.leave), t.leave);
  return t;
}

/// Paths whose rays are not the last, or meet such a box.
FN maskw finds_more_w(const Scene* scene, const Paths_w* path) {
  maskw finds = lt_int_w(path->depth, splat_int_w(scene->index[HEADER_LAST_DEPTH]));
  if (!any_w(path->alive & ~finds)) return finds;
  PRIVATE const realw* o = path->rays.planes + RAY_PLANE_O;
  PRIVATE const realw* inv = path->rays.planes + RAY_PLANE_INV;
  realw by = splat_w(R(0x1p-10)) * largest_of_w(o[0], o[1], o[2]);
  GLOBAL const real* box = scene->shading + scene->index[HEADER_GLOWING];
  for (int i = 0; i < scene->index[HEADER_GLOWING_COUNT]; ++i, box += 6) {
    Interval_w t;
    t.enter = splat_w(R(0.0));
    t.leave = splat_w(REAL_MAX);
    for (int axis = 0; axis < 3; ++axis) t = clip_last_w(t, box[axis], box[3 + axis], by, o[axis], inv[axis]);
    finds = finds | le_w(t.enter, t.leave);
  }
  return finds;
}
