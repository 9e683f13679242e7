// SPDX-License-Identifier: MIT
// LANES vectors as rows of a square, and the square's columns. In registers: a gather from what has just been stored
// waits until the stores have ended. More than one lane. One width; no guard.

/// The lower halves of a and b, element by element in turns, and the upper ones.
#if ON_HOST
FN realw zip_w(realw a, realw b, int first) {
  realw zipped;
  for (int i = 0; i < LANES; ++i) zipped[i] = (i & 1) == 0 ? a[first + i / 2] : b[first + i / 2];
  return zipped;
}
FN realw zip_low_w(realw a, realw b) { return zip_w(a, b, 0); }
FN realw zip_high_w(realw a, realw b) { return zip_w(a, b, LANES / 2); }
#elif LANES == 16
FN realw zip_low_w(realw a, realw b) {
  return (realw)(a.s0, b.s0, a.s1, b.s1, a.s2, b.s2, a.s3, b.s3, a.s4, b.s4, a.s5, b.s5, a.s6, b.s6, a.s7, b.s7);
}
FN realw zip_high_w(realw a, realw b) {
  return (realw)(a.s8, b.s8, a.s9, b.s9, a.sa, b.sa, a.sb, b.sb, a.sc, b.sc, a.sd, b.sd, a.se, b.se, a.sf, b.sf);
}
#else
FN realw zip_low_w(realw a, realw b) { return (realw)(a.s0, b.s0, a.s1, b.s1, a.s2, b.s2, a.s3, b.s3); }
FN realw zip_high_w(realw a, realw b) { return (realw)(a.s4, b.s4, a.s5, b.s5, a.s6, b.s6, a.s7, b.s7); }
#endif

/// rows[i] becomes what lane i of all rows was. A turn moves the highest bit of the row's number to the end of the
/// lane's number, whose highest bit moves to the end of the row's: H. S. Stone, "Parallel Processing with the Perfect
/// Shuffle", IEEE Transactions on Computers C-20(2), 1971.
FN void transpose_w(PRIVATE realw* rows) {
  UNROLLED
  for (int turn = 0; turn < (LANES == 16 ? 4 : 3); ++turn) {
    realw next[LANES];
    UNROLLED
    for (int i = 0; i < LANES / 2; ++i) {
      next[2 * i] = zip_low_w(rows[i], rows[i + LANES / 2]);
      next[2 * i + 1] = zip_high_w(rows[i], rows[i + LANES / 2]);
    }
    UNROLLED
    for (int i = 0; i < LANES; ++i) rows[i] = next[i];
  }
}

/// Ints as bits of reals, to be moved beside them and never computed with.
FN realw real_bits_of_int_w(intw i) { return LANE_AS_REAL(LANE_TO_MASK(i)); }
FN intw int_of_real_bits_w(realw x) { return LANE_TO_INT(LANE_AS_MASK(x)); }
