// SPDX-License-Identifier: MIT
// fma of single precision in integers, for devices without one (Mesa's llvmpipe): a b + c, rounded once to nearest for
// all operands, denormal ones included. It has no branch and calls no function of ours, because compilers of such
// devices are slow with both (docs/decisions/0018-soft-fma.md).
//
// A finite number is s 2^(p - 150), where s < 2^24 are its significant digits and p its exponent's field, or 1 where
// that is 0. In 64 bits the product, of 48 digits, is shifted up by 13, the third operand by at most 37. Digits below
// the lowest bit are merged into it (a sticky bit). So where one of the two loses digits, the other has 12 digits more
// than the result.
#ifndef STRAHL_MATH_SOFT_FMA_H
#define STRAHL_MATH_SOFT_FMA_H

FN real soft_fma(real a, real b, real c) {
  uint a_bits = real_to_bits(a), b_bits = real_to_bits(b), c_bits = real_to_bits(c);
  int a_field = (int)(a_bits >> 23 & 255u), b_field = (int)(b_bits >> 23 & 255u), c_field = (int)(c_bits >> 23 & 255u);
  // The first digit is 0 of a denormal number, else 1.
  ulong product = (ulong)((a_bits & 0x7fffffu) | (uint)min(a_field, 1) << 23) *
                      (ulong)((b_bits & 0x7fffffu) | (uint)min(b_field, 1) << 23)
                  << 13;
  ulong added = (ulong)((c_bits & 0x7fffffu) | (uint)min(c_field, 1) << 23);

  // In units of 2^place. A product of 0 stands below everything.
  int place = select(max(a_field, 1) + max(b_field, 1) - 313, -1000, product == 0UL);
  int up = max(c_field, 1) - 150 - place, down = min(max(up - 37, 0), 63);
  place += max(up - 37, 0);
  product = product >> down | (ulong)(uint)(product >> down << down != product);
  added <<= min(max(up, 0), 37);
  down = min(max(-up, 0), 63);
  added = added >> down | (ulong)(uint)(added >> down << down != added);

  // Negative numbers as two's complement.
  uint sign = (a_bits ^ b_bits) >> 31, differ = sign ^ c_bits >> 31;
  ulong sum = product + ((added ^ (0UL - differ)) + differ);
  uint is_negative = (uint)(sum >> 63), is_zero = (uint)(sum == 0UL);
  sum = (sum ^ (0UL - is_negative)) + is_negative;
  sign = (sign ^ is_negative) & ~(is_zero & differ);

  // Its highest digit to bit 61, then all but 24 of them are rounded off, or more where it is denormal.
  int rise = (int)clz(sum | 1UL) - 2, field = place - rise + 187;
  sum <<= rise;
  int off = min(38 + max(field, 0) - field, 63);
  uint digits = (uint)((sum + ((1UL << (off - 1)) - 1UL) + (sum >> off & 1UL)) >> off);
  // The first digit and what rounding carries count into the exponent.
  uint bits = min(((uint)max(field, 0) << 23) + digits, 0x7f800000u) & (is_zero - 1u);

  return select(select(bits_to_real(bits | sign << 31), c, c_field == 255), a * b + c, max(a_field, b_field) == 255);
}

#endif
