// SPDX-License-Identifier: MIT
// The two texels of a row that are next to a place, of images and volumes. Textures and media include this file: once
// per width.
#if !((LANES == 1 && defined(STRAHL_NEIGHBOURS_1)) || (LANES == 8 && defined(STRAHL_NEIGHBOURS_8)) || \
      (LANES == 16 && defined(STRAHL_NEIGHBOURS_16)))
#if LANES == 1
#define STRAHL_NEIGHBOURS_1
#elif LANES == 8
#define STRAHL_NEIGHBOURS_8
#else
#define STRAHL_NEIGHBOURS_16
#endif

/// Where x of the infinite plane lies in the image, in [0, 1]; 0 where x is not finite.
FN realw wrapped_w(realw x, int wrap) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), inside = x;
  if (wrap == WRAP_REPEAT) inside = x - floor_w(x);
  if (wrap == WRAP_MIRROR) {
    realw turns = splat_w(R(0.5)) * x, part = turns - floor_w(turns);
    inside = splat_w(R(2.0)) * min_w(part, one - part);
  }
  inside = sel_w(lt_w(inside, one), inside, one);
  return sel_w(finite_w(x) & lt_w(zero, inside), inside, zero);
}

/// Two neighbours of a row or column, and the weight of the second.
typedef struct {
  intw first, second;
  realw weight;
} Neighbours_w;

/// inside: as of wrapped.
FN Neighbours_w neighbours_w(realw inside, int size, int wrap, int filter) {
  Neighbours_w n;
  realw x = splat_w((real)size) * inside;
  intw last = splat_int_w(size - 1), zero = splat_int_w(0);
  if (filter == FILTER_NEAREST) {
    n.first = int_of_real_w(x);
    n.first = n.second = sel_int_w(lt_int_w(last, n.first), last, n.first);
    n.weight = splat_w(R(0.0));
    return n;
  }
  realw from_first = x - splat_w(R(0.5)), below = floor_w(from_first);
  n.weight = from_first - below;
  n.first = int_of_real_w(below);
  n.second = n.first + splat_int_w(1);
  intw before = wrap == WRAP_REPEAT ? last : zero, behind = wrap == WRAP_REPEAT ? zero : last;
  n.first = sel_int_w(lt_int_w(n.first, zero), before, n.first);
  n.second = sel_int_w(lt_int_w(last, n.second), behind, n.second);
  return n;
}
#endif
