// SPDX-License-Identifier: MIT
// The last ray of a path only looks for emission. It is followed only where it meets one of the boxes around all that
// emits, which are larger than roundings (src/packing/path_lengths.cpp), so the picture does not depend on it. One
// width; no guard.

/// Whether rays meet a box, lo x y z, hi x y z. o, inv: their planes of those names. by: how much larger the box is.
FN maskw meets_glowing_w(GLOBAL const real* box, realw by, PRIVATE const realw* o, PRIVATE const realw* inv) {
  realw enter = splat_w(R(0.0)), leave = splat_w(REAL_MAX);
  for (int axis = 0; axis < 3; ++axis) {
    realw a = (splat_w(box[axis]) - by - o[axis]) * inv[axis];
    realw b = (splat_w(box[3 + axis]) + by - o[axis]) * inv[axis];
    // Where a NaN comes from a ray in the plane of a face, the other plane says nothing either.
    maskw is_known = ~nan_w(a) & ~nan_w(b);
    enter = sel_w(is_known, max_w(min_w(b, a), enter), enter);
    leave = sel_w(is_known, min_w(max_w(b, a), leave), leave);
  }
  return le_w(enter, leave);
}

/// Paths whose rays are not the last, or meet such a box.
FN maskw finds_more_w(const Scene* scene, const Paths_w* path) {
  maskw finds = lt_int_w(path->depth, splat_int_w(scene->index[HEADER_LAST_DEPTH]));
  if (!any_w(path->alive & ~finds)) return finds;
  PRIVATE const realw* o = path->rays.planes + RAY_PLANE_O;
  realw by = splat_w(R(0x1p-10)) * largest_of_w(o[0], o[1], o[2]);
  GLOBAL const real* box = scene->shading + scene->index[HEADER_GLOWING];
  for (int i = 0; i < scene->index[HEADER_GLOWING_COUNT]; ++i, box += 6)
    finds = finds | meets_glowing_w(box, by, o, path->rays.planes + RAY_PLANE_INV);
  return finds;
}
