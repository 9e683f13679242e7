// SPDX-License-Identifier: MIT
// Whether a ray's line meets a box, exactly, one width; no guard. Where rounding could have exchanged entry and exit,
// every entry is compared with every exit again: (n - o) / d_i <= (f - o) / d_j becomes (n - o) |d_j| <= (f - o) |d_i|,
// differences exact, products in three-fold precision.

/// Lanes of `hit`, corrected where enter and leave are too close for their own errors of 1.5 u each.
FN maskw box_exact_w(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids, realw enter, realw leave,
                     maskw hit) {
  realw zero = splat_w(R(0.0));
  realw scale = max_w(abs_w(enter), abs_w(leave));
  maskw unsure = le_w(abs_w(enter - leave), splat_w(R(0x1p-21)) * scale);
  if (any_w(unsure)) unsure = unsure & is_there_w(ids);  // Padding is a point.
  if (!any_w(unsure)) return hit;

  dw_w in[3], out[3];
  real size[3];
  int entry[3];
  entry[0] = ray->near_x;
  entry[1] = ray->near_y;
  entry[2] = ray->near_z;
  maskw meets = unsure;
  for (int i = 0; i < 3; ++i) {
    realw near = load_w(block + entry[i] * LANES), far = load_w(block + (entry[i] ^ 1) * LANES);
    realw o = splat_w(component(ray->o, i));
    int backwards = entry[i] & 1;
    size[i] = real_abs(component(ray->d, i));
    in[i] = backwards ? two_sum_w(o, -near) : two_sum_w(near, -o);
    out[i] = backwards ? two_sum_w(o, -far) : two_sum_w(far, -o);
    // Rejects a ray that does not move along this axis and lies outside of the slab, and lanes without a box.
    if (!(size[i] > R(0.0))) meets = meets & le_w(in[i].hi, zero) & le_w(zero, out[i].hi);
    meets = meets & (backwards ? le_w(far, near) : le_w(near, far));
  }
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      if (i == j || !(size[i] > R(0.0)) || !(size[j] > R(0.0))) continue;
      meets = meets & le_w(zero, dw_difference_of_products_w(out[j], splat_w(size[i]), in[i], splat_w(size[j])).hi);
    }
  return (hit & ~unsure) | meets;
}
