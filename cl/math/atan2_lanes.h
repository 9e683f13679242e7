// SPDX-License-Identifier: MIT
// atan2_turns of math/angle.h in lanes, operation by operation: the same bits (tests/physics/test_environment.cpp).
// Several lights include this file: once per width.
#if !((LANES == 1 && defined(STRAHL_ATAN2_1)) || (LANES == 8 && defined(STRAHL_ATAN2_8)) || \
      (LANES == 16 && defined(STRAHL_ATAN2_16)))
#if LANES == 1
#define STRAHL_ATAN2_1
#elif LANES == 8
#define STRAHL_ATAN2_8
#else
#define STRAHL_ATAN2_16
#endif
#include "math/angle.h"

#define ANGLE_FIRST(c) realw tail = splat_w(c);
#define ANGLE_NEXT(c) tail = fma_w(z, tail, splat_w(c));
FN realw angle_atan_tail_w(realw z) {
  ANGLE_ATAN_TAIL(ANGLE_FIRST, ANGLE_NEXT)
  return tail;
}
#undef ANGLE_FIRST
#undef ANGLE_NEXT

FN realw atan2_turns_w(realw y, realw x) {
  realw ax = abs_w(x), ay = abs_w(y), zero = splat_w(R(0.0)), one = splat_w(R(1.0));
  maskw is_steep = lt_w(ax, ay);
  realw high = sel_w(is_steep, ay, ax), low = sel_w(is_steep, ax, ay);
  maskw is_huge = le_w(splat_w(ANGLE_HUGE), high), is_zero = eq_w(high, zero);
  realw down = sel_w(is_huge, splat_w(R(0.25)), one);
  high = sel_w(is_zero, one, high * down);
  low = low * down;
  maskw is_diagonal = lt_w(splat_w(R(0.41421356237309505)) * high, low);
  realw t = sel_w(is_diagonal, low - high, low) / sel_w(is_diagonal, low + high, high);
  realw z = t * t;
  realw a = fma_w(t, splat_w(ANGLE_TURN_HIGH), t * fma_w(z, angle_atan_tail_w(z), splat_w(ANGLE_TURN_LOW)));

  maskw is_left = lt_w(x, zero), is_low = lt_w(y, zero);
  realw base = sel_w(is_diagonal, splat_w(R(0.125)), zero);
  base = sel_w(is_steep, splat_w(R(0.25)) - base, base);
  base = sel_w(is_left, splat_w(R(0.5)) - base, base);
  base = sel_w(is_low, one - base, base);
  realw sign = sel_w(is_steep, -one, one);
  sign = sel_w(is_left, -sign, sign);
  sign = sel_w(is_low, -sign, sign);
  realw angle = base + sign * a;
  return sel_w(is_zero, zero, sel_w(lt_w(angle, one), angle, splat_w(ANGLE_BELOW_ONE)));
}
#endif
