// SPDX-License-Identifier: MIT
// Sums and products beyond the precision of real, one width; no guard. u is the unit roundoff, 2^-24 in float.
// A dw_w is the unevaluated sum hi + lo with |lo| <= u |hi|: T. J. Dekker, "A floating-point technique for extending
// the available precision", Numer. Math. 18, 1971; algorithms and bounds: M. Joldes, J.-M. Muller, V. Popescu, "Tight
// and rigorous error bounds for basic building blocks of double-word arithmetic", ACM TOMS 44(2), 2017. A sum3_w holds
// a sum of products as if in three-fold precision: T. Ogita, S. M. Rump, S. Oishi, "Accurate sum and dot product", SIAM
// J. Sci. Comput. 26(6), 2005. Bounds hold barring overflow, and underflow of the error terms: operands and results
// beyond 10^-12 ... 10^18.

/// A bound on the relative error of every operation on double words below: division's 12 u^2. A test makes it 1.
#ifndef DOUBLE_WORD_ROUNDOFF
#define DOUBLE_WORD_ROUNDOFF R(0x1p-44)
#endif

typedef struct {
  realw hi, lo;
} dw_w;

typedef struct {
  realw hi, mid, lo;
} sum3_w;

/// a + b, exactly. Six operations (Knuth), whatever the magnitudes.
FN dw_w two_sum_w(realw a, realw b) {
  dw_w s;
  s.hi = a + b;
  realw of_b = s.hi - a;
  s.lo = (a - (s.hi - of_b)) + (b - of_b);
  return s;
}

/// a + b, exactly, for |a| >= |b| or a = 0 (Dekker).
FN dw_w quick_two_sum_w(realw a, realw b) {
  dw_w s;
  s.hi = a + b;
  s.lo = b - (s.hi - a);
  return s;
}

/// a b, exactly.
FN dw_w two_prod_w(realw a, realw b) {
  dw_w p;
  p.hi = a * b;
  p.lo = fma_w(a, b, -p.hi);
  return p;
}

INLINE_FN dw_w dw_negate_w(dw_w x) {
  x.hi = -x.hi;
  x.lo = -x.lo;
  return x;
}

/// m ? x : y.
INLINE_FN dw_w dw_sel_w(maskw m, dw_w x, dw_w y) {
  x.hi = sel_w(m, x.hi, y.hi);
  x.lo = sel_w(m, x.lo, y.lo);
  return x;
}

/// Relative error at most 3 u^2 + 13 u^3, cancellation included (AccurateDWPlusDW).
FN dw_w dw_add_w(dw_w x, dw_w y) {
  dw_w s = two_sum_w(x.hi, y.hi), t = two_sum_w(x.lo, y.lo);
  dw_w v = quick_two_sum_w(s.hi, s.lo + t.hi);
  return quick_two_sum_w(v.hi, t.lo + v.lo);
}

/// x y of two double words, relative error at most 5 u^2 (DWTimesDW3).
FN dw_w dw_mul_w(dw_w x, dw_w y) {
  dw_w p = two_prod_w(x.hi, y.hi);
  realw cross_terms = fma_w(x.lo, y.hi, fma_w(x.hi, y.lo, x.lo * y.lo));
  return quick_two_sum_w(p.hi, p.lo + cross_terms);
}

/// x y, relative error at most 2 u^2 (DWTimesFP3).
FN dw_w dw_scale_w(dw_w x, realw y) {
  dw_w p = two_prod_w(x.hi, y);
  return quick_two_sum_w(p.hi, fma_w(x.lo, y, p.lo));
}

/// x / y, relative error below 12 u^2: the quotient of the high words leaves a remainder that fma gives exactly; it and
/// the low words, at most 3 u of the whole, then take four roundings.
FN dw_w dw_div_w(dw_w x, dw_w y) {
  realw q = x.hi / y.hi;
  realw rest = fma_w(-q, y.hi, x.hi) + fma_w(-q, y.lo, x.lo);
  return quick_two_sum_w(q, rest / y.hi);
}

/// Square root of x >= 0, relative error below 4 u^2. V. Lefevre, N. Louvet, J.-M. Muller, J. Picot, L. Rideau,
/// "Accurate calculation of Euclidean norms using double-word arithmetic", ACM TOMS 49(1), 2023 (SQRTDWtoDW).
FN dw_w dw_sqrt_w(dw_w x) {
  realw s = sqrt_w(x.hi);
  realw rest = fma_w(-s, s, x.hi) + x.lo;
  realw correction = rest / (s + s);
  return quick_two_sum_w(s, sel_w(lt_w(splat_w(R(0.0)), s), correction, s));
}

/// a b + c d, begun.
FN sum3_w sum3_begin_w(realw a, realw b, realw c, realw d) {
  dw_w p = two_prod_w(a, b), q = two_prod_w(c, d);
  dw_w high = two_sum_w(p.hi, q.hi), low = two_sum_w(p.lo, q.lo), mid = two_sum_w(low.hi, high.lo);
  sum3_w s;
  s.hi = high.hi;
  s.mid = mid.hi;
  s.lo = low.lo + mid.lo;
  return s;
}

/// s + a b.
INLINE_FN sum3_w sum3_add_w(sum3_w s, realw a, realw b) {
  dw_w p = two_prod_w(a, b);
  dw_w high = two_sum_w(s.hi, p.hi), low = two_sum_w(s.mid, p.lo), mid = two_sum_w(low.hi, high.lo);
  s.hi = high.hi;
  s.mid = mid.hi;
  s.lo = s.lo + (low.lo + mid.lo);
  return s;
}

/// The sum of n products as a double word: within 2 u^2 of itself plus (4 n u)^3 / 8 of the sum of absolute values.
FN dw_w sum3_round_w(sum3_w s) {
  dw_w high = two_sum_w(s.hi, s.mid);
  return two_sum_w(high.hi, high.lo + s.lo);
}

typedef struct {
  dw_w x, y, z;
} dw3_w;

/// p - q, exactly.
FN dw3_w two_difference3_w(realw px, realw py, realw pz, realw qx, realw qy, realw qz) {
  dw3_w f;
  f.x = two_sum_w(px, -qx);
  f.y = two_sum_w(py, -qy);
  f.z = two_sum_w(pz, -qz);
  return f;
}

/// f.v, as sum3_round_w says.
FN dw_w dot_real3_w(dw3_w f, realw x, realw y, realw z) {
  sum3_w s = sum3_begin_w(f.x.hi, x, f.y.hi, y);
  s = sum3_add_w(s, f.z.hi, z);
  s = sum3_add_w(s, f.x.lo, x);
  s = sum3_add_w(s, f.y.lo, y);
  return sum3_round_w(sum3_add_w(s, f.z.lo, z));
}

/// a.b of plain vectors, as sum3_round_w says.
FN dw_w real_dot_real3_w(realw ax, realw ay, realw az, realw bx, realw by, realw bz) {
  return sum3_round_w(sum3_add_w(sum3_begin_w(ax, bx, ay, by), az, bz));
}

/// f a - g b, as sum3_round_w says: one component of a cross product.
FN dw_w dw_difference_of_products_w(dw_w f, realw a, dw_w g, realw b) {
  sum3_w s = sum3_begin_w(f.hi, a, -g.hi, b);
  s = sum3_add_w(s, f.lo, a);
  return sum3_round_w(sum3_add_w(s, -g.lo, b));
}

/// f x v.
FN dw3_w cross_real3_w(dw3_w f, realw x, realw y, realw z) {
  dw3_w c;
  c.x = dw_difference_of_products_w(f.y, z, f.z, y);
  c.y = dw_difference_of_products_w(f.z, x, f.x, z);
  c.z = dw_difference_of_products_w(f.x, y, f.y, x);
  return c;
}

/// f.g, within 14 u^2 of |f| |g|.
FN dw_w dw_dot3_w(dw3_w f, dw3_w g) {
  return dw_add_w(dw_add_w(dw_mul_w(f.x, g.x), dw_mul_w(f.y, g.y)), dw_mul_w(f.z, g.z));
}
