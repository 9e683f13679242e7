// SPDX-License-Identifier: MIT
// Binary128 arithmetic that carries a bound of its own rounding error (running error analysis: Higham, Accuracy and
// Stability of Numerical Algorithms, 2nd ed., section 3.3). It answers a sign only where the bound allows it and throws
// Uncertain otherwise; the caller repeats the computation in rationals (number.h). No sign obtained here is a guess.
#pragma once

#include <array>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "oracle/exact.h"

namespace strahl::oracle {

#ifdef __SIZEOF_FLOAT128__
__extension__ typedef __float128 Quad;
#else
static_assert(LDBL_MANT_DIG == 113, "the filter needs a binary128 type");
typedef long double Quad;
#endif

/// Thrown by sign() and to_exact() where the error bound does not allow an answer.
struct Uncertain {};

/// A number within [value - error, value + error]. Overflow makes the error infinite, hence every answer uncertain.
class Filtered {
 public:
  Filtered(double exact = 0) : value_(exact) {}

  friend Filtered operator+(const Filtered& a, const Filtered& b) {
    return rounded(a.value_ + b.value_, a.error_ + b.error_);
  }
  friend Filtered operator-(const Filtered& a, const Filtered& b) {
    return rounded(a.value_ - b.value_, a.error_ + b.error_);
  }
  friend Filtered operator-(const Filtered& a) { return Filtered(-a.value_, a.error_); }
  friend Filtered operator*(const Filtered& a, const Filtered& b) {
    if (a.is_exact_zero() || b.is_exact_zero()) return 0;
    return rounded(a.value_ * b.value_,
                   magnitude(a) * b.error_ + magnitude(b) * a.error_ + a.error_ * b.error_ + underflow);
  }
  friend Filtered operator/(const Filtered& a, const Filtered& b) {
    const long double divisor = magnitude(b) - b.error_;
    if (!(divisor > 0)) throw Uncertain{};
    const Filtered quotient(a.value_ / b.value_, 0);
    return rounded(quotient.value_, (a.error_ + magnitude(quotient) * b.error_) / divisor + underflow);
  }
  /// Of a number that is certainly positive.
  friend Filtered sqrt(const Filtered& a) {
    const long double least = magnitude(a) - a.error_;
    if (!(least > 0)) throw Uncertain{};
    // One Newton step doubles the 64 bits of the start.
    const Quad start = std::sqrt(static_cast<long double>(a.value_));
    return rounded(start + (a.value_ - start * start) / (2 * start), a.error_ / std::sqrt(least));
  }

  friend int sign(const Filtered& a) {
    if (a.is_exact_zero()) return 0;
    if (!(magnitude(a) > a.error_)) throw Uncertain{};
    return a.value_ > 0 ? 1 : -1;
  }
  friend double to_double(const Filtered& a) { return static_cast<double>(a.value_); }
  /// a / b rounded, where the two alone might leave the range of double; b is not 0.
  friend double ratio(const Filtered& a, const Filtered& b) {
    return static_cast<double>(static_cast<long double>(a.value_) / static_cast<long double>(b.value_));
  }
  friend Exact to_exact(const Filtered& a) {
    if (a.is_exact_zero()) return {};
    if (!(a.error_ <= magnitude(a) * 0x1p-81L)) throw Uncertain{};
    const Exact t{static_cast<double>(a.value_), static_cast<double>(a.value_ - static_cast<double>(a.value_))};
    const bool rounds_surely = static_cast<double>(a.value_ - static_cast<Quad>(a.error_)) == t.value &&
                               static_cast<double>(a.value_ + static_cast<Quad>(a.error_)) == t.value;
    if (!rounds_surely) throw Uncertain{};
    return t;
  }

 private:
  Filtered(Quad value, long double error) : value_(value), error_(error) {}

  // Four times the unit roundoff 2^-113: it covers the last Newton step of the square root and, as every error has its
  // origin here, the rounding of the bound itself (2^-64 an operation).
  static Filtered rounded(Quad value, long double propagated) {
    const Filtered result(value, propagated);
    return Filtered(value, propagated + magnitude(result) * 0x1p-111L);
  }
  /// To 2^-63. The x87 format has binary128's exponent and the first half of its digits: copying them is several times
  /// faster than the library's conversion, which the oracle would spend a quarter of its time in.
  static long double magnitude(const Filtered& a) {
#if defined(__SIZEOF_FLOAT128__) && LDBL_MANT_DIG == 64 && defined(__x86_64__)
    std::array<std::uint64_t, 2> quad;
    std::memcpy(quad.data(), &a.value_, sizeof quad);
    const std::uint64_t exponent = quad[1] >> 48 & 0x7fff;
    if (exponent != 0 && exponent != 0x7fff) {
      const std::uint64_t digits = std::uint64_t{1} << 63 | (quad[1] & 0xffffffffffff) << 15 | quad[0] >> 49;
      long double copy = 0;
      std::memcpy(&copy, &digits, sizeof digits);
      std::memcpy(reinterpret_cast<unsigned char*>(&copy) + sizeof digits, &exponent, 2);
      return copy;
    }
#endif
    return std::fabs(static_cast<long double>(a.value_));
  }
  bool is_exact_zero() const { return error_ == 0 && value_ == 0; }

  // Above every loss by underflow in value or bound, far below every product of twelve doubles.
  static constexpr long double underflow = 0x1p-16300L;

  Quad value_;
  long double error_ = 0;
};

}  // namespace strahl::oracle
