// SPDX-License-Identifier: MIT
// t of a ray and a primitive, correctly rounded for any finite numbers: the signs of the polynomials that define it, at
// the midpoints of neighbouring reals, bisect what is known of it (docs/decisions/0023-correctly-rounded-t.md). Slow,
// for the few t that neither doubles nor double words can tell from a midpoint. Single precision, one lane.
#ifndef STRAHL_SHAPES_EXACT_T_H
#define STRAHL_SHAPES_EXACT_T_H

#include "rays/ray.h"
#include "shapes/exact/exact_sum.h"

/// What t is a root of. EXACT_PLANE: b.(a - o) / (b.d). EXACT_POLYGON: n.(a - o) / (n.d), n = a x b + b x c + c x a.
/// EXACT_SPHERE: |o + t d - a| = r. EXACT_MANTLE: |(o + t d - a) x b| = r |b|.
enum { EXACT_PLANE, EXACT_POLYGON, EXACT_SPHERE, EXACT_MANTLE };

/// The polynomial in t that is 0 there; its slope, or half of that; the same at t / 2; the discriminant of a sphere.
enum { EXACT_VALUE, EXACT_SLOPE, EXACT_HALFWAY, EXACT_DISCRIMINANT };

/// Roots of a quadratic: the first, the second; the second as seen from where the first is 0, twice the way to their
/// middle.
enum { EXACT_NEAR, EXACT_FAR, EXACT_ACROSS };

/// A ray, and what a kind needs of a, b, c and r.
typedef struct {
  real3 o, d, a, b, c;
  real r;
} ExactCase;

/// Reals counted upwards: 0 is 0, 1 the least positive number.
FN int ordered_of(real x) {
  int bits = (int)(real_to_bits(x) & 0x7fffffffu);
  return sign_bit(x) ? -bits : bits;
}

FN real real_of_ordered(int order) {
  uint size = (uint)(order < 0 ? -order : order);
  return bits_to_real(order < 0 ? size | 0x80000000u : size);
}

/// Between the real of this order and the next.
FN ExactNumber exact_midpoint(int order) {
  ExactNumber n = exact_number(real_of_ordered(order < 0 ? order + 1 : order));
  n.d0 = n.d0 * 2u + 1u;
  n.place -= 1;
  n.negative = (uint)(order < 0);
  return n;
}

INLINE_FN void factor_add(PRIVATE ExactFactor* factor, ExactNumber n) { factor->of[factor->count++] = n; }

/// s p x q along axis i.
FN void factor_add_cross(PRIVATE ExactFactor* factor, ExactNumber s, real3 p, real3 q, int i) {
  int j = i == 2 ? 0 : i + 1, k = j == 2 ? 0 : j + 1;
  factor_add(factor, exact_times(exact_times(s, component(p, j)), component(q, k)));
  factor_add(factor, exact_negated(exact_times(exact_times(s, component(p, k)), component(q, j))));
}

/// One axis of a polynomial: x y, and + or - z z.
typedef struct {
  ExactFactor x, y, z;
  uint is_negative, is_z_negative;
} ExactTerms;

/// Along axis i, at t = m.
FN void exact_terms(int kind, int polynomial, PRIVATE const ExactCase* c, ExactNumber m, int i,
                    PRIVATE ExactTerms* terms) {
  PRIVATE ExactFactor *x = &terms->x, *y = &terms->y, *z = &terms->z;
  ExactNumber one = exact_number(R(1.0)), minus_one = exact_negated(one);
  real o = component(c->o, i), d = component(c->d, i), a = component(c->a, i), b = component(c->b, i);
  x->count = y->count = z->count = 0;
  terms->is_negative = 0u;
  terms->is_z_negative = 1u;
  if (kind == EXACT_PLANE || kind == EXACT_POLYGON) {
    if (kind == EXACT_PLANE) {
      factor_add(x, exact_number(b));
    } else {
      factor_add_cross(x, one, c->a, c->b, i);
      factor_add_cross(x, one, c->b, c->c, i);
      factor_add_cross(x, one, c->c, c->a, i);
    }
    if (polynomial == EXACT_SLOPE) {
      factor_add(y, exact_number(d));
    } else {
      factor_add(y, exact_number(a));
      factor_add(y, exact_negated(exact_number(o)));
      factor_add(y, exact_negated(exact_times(m, d)));
    }
  } else if (polynomial == EXACT_DISCRIMINANT) {
    factor_add_cross(x, one, c->o, c->d, i);
    factor_add_cross(x, minus_one, c->a, c->d, i);
    *y = *x;
    terms->is_negative = 1u;
    factor_add(z, exact_times(exact_number(c->r), d));
    terms->is_z_negative = 0u;
  } else if (kind == EXACT_SPHERE) {
    factor_add(x, exact_number(o));
    factor_add(x, exact_negated(exact_number(a)));
    factor_add(x, exact_times(m, d));
    *y = *x;
    if (polynomial == EXACT_VALUE && i == 0) factor_add(z, exact_number(c->r));
  } else {
    factor_add_cross(x, one, c->o, c->b, i);
    factor_add_cross(x, minus_one, c->a, c->b, i);
    factor_add_cross(x, m, c->d, c->b, i);
    *y = *x;
    if (polynomial == EXACT_VALUE) factor_add(z, exact_times(exact_number(c->r), b));
  }
  int is_slope = polynomial == EXACT_SLOPE || polynomial == EXACT_HALFWAY;
  if (is_slope && (kind == EXACT_SPHERE || kind == EXACT_MANTLE)) {
    y->count = 0;
    if (kind == EXACT_SPHERE)
      factor_add(y, exact_number(d));
    else
      factor_add_cross(y, one, c->d, c->b, i);
  }
}

/// Of the polynomial at the midpoint after the real of this order: -1, 0 or 1. A program holds one for all kinds,
/// and it calls nothing (docs/decisions/0017-once.md).
SELDOM_FN int exact_sign_of(int kind, int polynomial, PRIVATE const ExactCase* c, int order) {
  ExactSum sum;
  ExactTerms terms;
  ExactNumber m = exact_midpoint(order);
  if (polynomial == EXACT_HALFWAY) m.place -= 1;
  exact_clear(&sum);
  for (int i = 0; i < 3; ++i) {
    exact_terms(kind, polynomial, c, m, i, &terms);
    for (int k = 0; k < 2; ++k)
      exact_add_product(&sum, k == 0 ? &terms.x : &terms.z, k == 0 ? &terms.y : &terms.z,
                        k == 0 ? terms.is_negative : terms.is_z_negative);
  }
  return exact_sign(&sum);
}

/// What is known of t: the orders of the least and the largest real that it may round to.
typedef struct {
  int least, most;
} ExactRange;

/// Bounds that are no numbers: nothing is known.
FN ExactRange exact_range(real least, real most) {
  ExactRange range;
  int is_known = least <= most, largest = 0x7f800000;
  range.least = is_known ? ordered_of(least) : -largest;
  range.most = is_known ? ordered_of(most) : largest;
  return range;
}

/// side: the sign of t less the midpoint after the real of order `at`. On the midpoint t is rounded to even.
FN void range_narrow(PRIVATE ExactRange* range, int at, int side) {
  if (side == 0)
    range->least = range->most = at + (at & 1);
  else if (side > 0)
    range->least = at + 1;
  else
    range->most = at;
}

/// Where the range is divided next. 0 is told from its neighbours first: rays that begin on the primitive have it, and
/// millions of reals are nearer to it than what is known.
FN int range_middle(ExactRange range) {
  if (range.least <= 0 && 0 <= range.most) return range.least < 0 ? -1 : 0;
  return (int)(((long)range.least + (long)range.most) >> 1);
}

FN int exact_is_finite(PRIVATE const ExactCase* c) {
  return is_finite3(c->o) & is_finite3(c->d) & is_finite3(c->a) & is_finite3(c->b) & is_finite3(c->c) &
         real_is_finite(c->r);
}

FN real exact_nothing(void) { return bits_to_real(0x7fc00000u); }

/// A plane's or a polygon's t, which is no less than `least` and no more than `most`, both rounded; NaN where the ray
/// is parallel.
FN real exact_quotient(int kind, PRIVATE const ExactCase* c, real least, real most) {
  ExactRange range = exact_range(least, most);
  int slope = 0;
  if (!exact_is_finite(c)) return exact_nothing();
  while (slope == 0 || range.least < range.most) {  // One place that adds: the slope first.
    int at = range_middle(range), sign = exact_sign_of(kind, slope == 0 ? EXACT_SLOPE : EXACT_VALUE, c, at);
    if (slope != 0) range_narrow(&range, at, sign * slope);
    if (slope == 0 && sign == 0) return exact_nothing();
    if (slope == 0) slope = sign;
  }
  return real_of_ordered(range.least);
}

/// The same for a root of a quadric that the line meets; NaN where its numbers are not finite.
FN real exact_root(int kind, PRIVATE const ExactCase* c, real least, real most, int root) {
  if (!exact_is_finite(c)) return exact_nothing();
  ExactRange range = exact_range(least, most);
  int is_across = root == EXACT_ACROSS, is_far = root == EXACT_FAR;
  while (range.least < range.most) {
    int at = range_middle(range), signs[2];
    signs[0] = 1;
    for (int i = is_across; i < 2; ++i)
      signs[i] = exact_sign_of(kind, is_across ? EXACT_HALFWAY : i == 0 ? EXACT_VALUE : EXACT_SLOPE, c, at);
    int value = signs[0], slope = signs[1], is_after = is_far ? value < 0 || slope < 0 : value > 0 && slope < 0;
    int is_at = is_across ? slope == 0 : value == 0 && (is_far || slope <= 0);
    range_narrow(&range, at, is_after ? 1 : is_at ? 0 : -1);
  }
  return real_of_ordered(range.least);
}

FN real exact_plane_t(PRIVATE const ExactCase* c, real least, real most) {
  return exact_quotient(EXACT_PLANE, c, least, most);
}

FN real exact_polygon_t(PRIVATE const ExactCase* c, real least, real most) {
  return exact_quotient(EXACT_POLYGON, c, least, most);
}

/// The first root of a sphere from t_min on, the last one where there is none; NaN where the line misses the sphere.
/// least, most: of the near root, then of the far one.
FN real exact_sphere_t(PRIVATE const ExactCase* c, real t_min, PRIVATE const real* least, PRIVATE const real* most) {
  real t = exact_nothing();
  if (!exact_is_finite(c) || exact_sign_of(EXACT_SPHERE, EXACT_DISCRIMINANT, c, 0) < 0) return t;
  for (int is_far = 0; is_far < 2 && !(t_min <= t); ++is_far)
    t = exact_root(EXACT_SPHERE, c, least[is_far], most[is_far], is_far ? EXACT_FAR : EXACT_NEAR);
  return t;
}

#endif
