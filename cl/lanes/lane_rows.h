// SPDX-License-Identifier: MIT
// Rows: consecutive reals, elsewhere for each lane, a field in each vector. Four at a time are read as they lie and
// transposed in registers, which takes a quarter of the time of a gather for each field. One width; no guard.
#if LANES == 1 || ON_HOST
FN void gather_row_w(GLOBAL const real* p, intw i, int count, PRIVATE realw* row) {
  for (int k = 0; k < count; ++k) row[k] = gather_w(p + k, i);
}
FN void gather_row_once_w(GLOBAL const real* p, intw i, int count, PRIVATE realw* row) {
  gather_row_w(p, i, count, row);
}
#else
#if REAL_BITS == 64
typedef double4 Four_w;
#else
typedef float4 Four_w;
#endif
#ifdef __clang__
// As store_w.
typedef Four_w FourAnywhere_w __attribute__((aligned(sizeof(real))));
FN Four_w load_four_w(GLOBAL const real* p) { return *(GLOBAL const FourAnywhere_w*)p; }
#else
FN Four_w load_four_w(GLOBAL const real* p) { return vload4(0, p); }
#endif

// zip: the first two, or the last two, of each four of a and b, in turns. join: those of a, then those of b.
#if LANES == 16
#define FOURS(p, i, k) load_four_w(p + i.s##k)
#define FOURS_AT(p, i, a, b, c, d) (realw)(FOURS(p, i, a), FOURS(p, i, b), FOURS(p, i, c), FOURS(p, i, d))
FN realw zip_first_w(realw a, realw b) {
  return (realw)(a.s0, b.s0, a.s1, b.s1, a.s4, b.s4, a.s5, b.s5, a.s8, b.s8, a.s9, b.s9, a.sc, b.sc, a.sd, b.sd);
}
FN realw zip_last_w(realw a, realw b) {
  return (realw)(a.s2, b.s2, a.s3, b.s3, a.s6, b.s6, a.s7, b.s7, a.sa, b.sa, a.sb, b.sb, a.se, b.se, a.sf, b.sf);
}
FN realw join_first_w(realw a, realw b) {
  return (realw)(a.s0, a.s1, b.s0, b.s1, a.s4, a.s5, b.s4, b.s5, a.s8, a.s9, b.s8, b.s9, a.sc, a.sd, b.sc, b.sd);
}
FN realw join_last_w(realw a, realw b) {
  return (realw)(a.s2, a.s3, b.s2, b.s3, a.s6, a.s7, b.s6, b.s7, a.sa, a.sb, b.sa, b.sb, a.se, a.sf, b.se, b.sf);
}
#else
#define FOURS_AT(p, i, a, b, c, d) (realw)(load_four_w(p + i.s##a), load_four_w(p + i.s##b))
FN realw zip_first_w(realw a, realw b) { return (realw)(a.s0, b.s0, a.s1, b.s1, a.s4, b.s4, a.s5, b.s5); }
FN realw zip_last_w(realw a, realw b) { return (realw)(a.s2, b.s2, a.s3, b.s3, a.s6, b.s6, a.s7, b.s7); }
FN realw join_first_w(realw a, realw b) { return (realw)(a.s0, a.s1, b.s0, b.s1, a.s4, a.s5, b.s4, b.s5); }
FN realw join_last_w(realw a, realw b) { return (realw)(a.s2, a.s3, b.s2, b.s3, a.s6, a.s7, b.s6, b.s7); }
#endif

/// p[i] to p[i + 3] of each lane.
FN void gather_four_w(GLOBAL const real* p, intw i, PRIVATE realw* row) {
  realw a = FOURS_AT(p, i, 0, 4, 8, c), b = FOURS_AT(p, i, 1, 5, 9, d);
  realw c = FOURS_AT(p, i, 2, 6, a, e), d = FOURS_AT(p, i, 3, 7, b, f);
  realw ab = zip_first_w(a, b), cd = zip_first_w(c, d), ab_last = zip_last_w(a, b), cd_last = zip_last_w(c, d);
  row[0] = join_first_w(ab, cd);
  row[1] = join_last_w(ab, cd);
  row[2] = join_first_w(ab_last, cd_last);
  row[3] = join_last_w(ab_last, cd_last);
}
#undef FOURS
#undef FOURS_AT

/// p[i] to p[i + count - 1] of each lane. count: 4 at least, and known when the program is compiled.
FN void gather_row_w(GLOBAL const real* p, intw i, int count, PRIVATE realw* row) {
  UNROLLED
  for (int k = 0; k + 4 <= count; k += 4) gather_four_w(p + k, i, row + k);
  if ((count & 3) != 0) gather_four_w(p + (count - 4), i, row + (count - 4));
}

ONCE_FN void gather_four_once_w(GLOBAL const real* p, intw i, PRIVATE realw* four) { gather_four_w(p, i, four); }

/// As gather_row_w, in less text: for what is seldom read.
FN void gather_row_once_w(GLOBAL const real* p, intw i, int count, PRIVATE realw* row) {
  UNROLLED
  for (int k = 0; k < count; k += 4) {
    int first = min(k, count - 4);
    realw four[4];  // The row itself stays in registers.
    gather_four_once_w(p + first, i, four);
    for (int j = 0; j < 4; ++j) row[first + j] = four[j];
  }
}
#endif
