// SPDX-License-Identifier: MIT
// Hard cases of division and square root lie next to the middle of two numbers, where one wrong bit of a quotient or an
// iteration too few shows: found by inverting modulo a power of two, and by Hensel lifting (W. Kahan, "A test for
// correctly rounded SQRT", 1996; J.-M. Muller et al., "Handbook of Floating-Point Arithmetic", 2018, ch. 4).
#include "trust/canary_cases.h"

#include <cmath>
#include <cstdint>
#include <limits>

namespace strahl {
namespace {

using namespace layout;

__extension__ typedef unsigned __int128 Wide;

/// SplitMix64 (Steele, Lea, Flood, "Fast Splittable Pseudorandom Number Generators", OOPSLA 2014).
class Bits {
 public:
  explicit Bits(std::uint64_t seed) : state_(seed) {}
  std::uint64_t operator()() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  int integer(int low, int high) {
    return low + static_cast<int>((*this)() % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  std::uint64_t state_;
};

template <typename Real>
struct Cases {
  using Limits = std::numeric_limits<Real>;
  static constexpr int p = Limits::digits;
  static constexpr Real infinity = Limits::infinity(), nan = Limits::quiet_NaN(), smallest = Limits::denorm_min();
  static constexpr int least = Limits::min_exponent - 1;  ///< Of the smallest normal number.

  Bits bits{1};
  std::vector<CanaryCase<Real>> list;

  void add(Real a, Real b = 1, Real c = 1, Real d = 1) { list.push_back({a, b, c, d}); }

  static Real power(int exponent) { return std::ldexp(Real(1), exponent); }

  /// All p bits random, in [2^exponent, 2^(exponent + 1)), either sign.
  Real draw(int exponent) {
    const std::uint64_t mantissa = (bits() >> (64 - p)) | (std::uint64_t{1} << (p - 1));
    const Real x = std::ldexp(static_cast<Real>(mantissa), exponent - (p - 1));
    return bits() >> 63 ? -x : x;
  }
  Real draw(int low, int high) { return draw(bits.integer(low, high)); }

  Real ulps_away(Real x, int count) {
    for (; count > 0; --count) x = std::nextafter(x, infinity);
    for (; count < 0; ++count) x = std::nextafter(x, -infinity);
    return x;
  }

  void ordinary(int count) {
    for (int i = 0; i < count; ++i) add(draw(-20, 20), draw(-20, 20), draw(-20, 20), draw(-20, 20));
  }

  void sums() {
    ordinary(1000);
    for (int i = 0; i < 1000; ++i) {
      const Real a = draw(0);
      add(a, draw(-p - 2, 2));
      add(a, -ulps_away(a, bits.integer(-3, 3)));
      // The tie to even, and its two neighbours.
      const Real half = power(-p) * (a < 0 ? -1 : 1);
      add(a, ulps_away(half, bits.integer(-1, 1)));
    }
  }

  void products() {
    ordinary(1000);
    for (int i = 0; i < 1000; ++i) {
      const Real a = draw(0), b = draw(0);
      add(a, b, ulps_away(a, bits.integer(-2, 2)), ulps_away(b, bits.integer(-2, 2)));
    }
  }

  /// a b + c and a b - c d whose one or three roundings show.
  void contraction() {
    for (int i = 0; i < 1000; ++i) {
      const Real a = draw(0), b = draw(0);
      add(a, b, -(a * b), b);
      add(a, b, a, b);
    }
  }

  /// a 2^(p + 1) = m b +- 1 with m odd of p + 1 bits: a / b is next to the middle of two numbers.
  void division() {
    for (int i = 0; i < 1000; ++i) add(draw(-20, 20), draw(-20, 20));
    const Wide modulus = Wide{1} << (p + 1);
    for (int i = 0; i < 6000; ++i) {
      const std::uint64_t b = (bits() >> (64 - p)) | (std::uint64_t{1} << (p - 1)) | 1;
      Wide inverse = b;  // Newton: each step doubles the bits that are right.
      for (int step = 0; step < 6; ++step) inverse = inverse * (2 - b * inverse);
      for (const bool is_above : {false, true}) {
        const Wide m = (is_above ? inverse : Wide{0} - inverse) % modulus;
        if (m >> p == 0) continue;
        const Wide a = is_above ? (m * b - 1) / modulus : (m * b + 1) / modulus;
        if (a >> p == 0) add(static_cast<Real>(static_cast<std::uint64_t>(a)), static_cast<Real>(b));
      }
    }
  }

  /// m^2 = r mod 2^(p + 1) with m odd of p + 1 bits and small r: the root of (m^2 - r) / 2^(p + 1) is next to a middle.
  void square_root() {
    for (int i = 0; i < 2000; ++i) {
      const Real a = std::fabs(draw(-20, 20));
      add(a);
      const Real whole = static_cast<Real>((bits() >> (64 - p / 2)) | 1);
      add(ulps_away(whole * whole, bits.integer(-1, 1)));
    }
    const Wide modulus = Wide{1} << (p + 1);
    for (std::int64_t r = -8 * 2000 + 1; r < 8 * 2000; r += 8) {
      Wide x = 1;
      for (int bit = 3; bit <= p; ++bit)
        if (((x * x - static_cast<Wide>(r)) >> bit & 1) != 0) x += Wide{1} << (bit - 1);
      for (const Wide half : {Wide{0}, modulus / 2})
        for (const Wide root : {x + half, Wide{0} - x + half}) {
          const Wide m = root % modulus;
          if (m >> p == 0) continue;
          const Wide a = (m * m - static_cast<Wide>(r)) / modulus;
          if (a >> (p - 1) != 1) continue;
          add(std::ldexp(static_cast<Real>(static_cast<std::uint64_t>(a)), (p + 1) % 2));
        }
    }
  }

  void denormals() {
    for (int i = 0; i < 500; ++i) {
      const Real tiny = draw(least - p + 2, least - 1);
      add(tiny, draw(least - 1, least + 2));
      add(tiny, power(bits.integer(0, 40)));
      add(draw(least, least + 2), power(bits.integer(1, 10)));
      const Real a = draw(least);
      add(a, ulps_away(a, bits.integer(-8, 8)));
      add(draw(least / 2), draw(least / 2 - 2));
      add(tiny, Real(0));
      add(tiny, -tiny);
    }
  }

  void fma_denormals() {
    for (int i = 0; i < 2000; ++i) {
      const Real a = draw(0), b = draw(least - bits.integer(-2, p));
      add(a, b, -(a * b));
      add(a, ulps_away(b, bits.integer(-8, 8)), -(a * b));
      add(draw(least / 2), draw(least / 2 - bits.integer(0, p)), draw(least - p + 3, least - 1));
    }
  }

  void order() {
    ordinary(500);
    for (int i = 0; i < 500; ++i) {
      const Real a = draw(-100, 100);
      add(a, ulps_away(a, bits.integer(-1, 1)));
    }
    for (const Real a : {Real(0), Real(-0.0), Real(1), Real(-1)})
      for (const Real b : {Real(0), Real(-0.0), Real(1), Real(-1)}) add(a, b);
  }

  void with_nan() {
    for (const Real a : {Real(0), Real(1), Real(-1), infinity, -infinity, nan}) {
      add(a, nan);
      add(nan, a);
    }
  }

  void infinities() {
    const Real largest = Limits::max();
    for (const Real a : {Real(0), Real(-0.0), Real(1), Real(-1), largest, -largest, infinity, -infinity})
      for (const Real b : {Real(0), Real(-0.0), Real(2), Real(-2), largest, -largest, infinity, -infinity}) add(a, b);
  }

  void conversions() {
    for (int i = 0; i < 500; ++i) add(std::fabs(draw(-4, 30)));
    for (int i = 0; i < 40; ++i) add(static_cast<Real>(i) / 4);
  }
};

template <typename Real>
CanaryGroup<Real> group(CanaryProperty property, std::vector<int> outputs, void (Cases<Real>::*fill)()) {
  Cases<Real> cases;
  (cases.*fill)();
  return {property, std::move(outputs), std::move(cases.list)};
}

template <typename Real>
CanaryGroup<Real> finite_arithmetic() {
  Cases<Real> cases;
  cases.ordinary(1000);
  return {CanaryProperty::finite_arithmetic,
          {CANARY_SUM, CANARY_PRODUCT, CANARY_QUOTIENT, CANARY_ROOT, CANARY_FMA},
          std::move(cases.list)};
}

}  // namespace

template <typename Real>
std::vector<CanaryGroup<Real>> canary_groups() {
  using P = CanaryProperty;
  using C = Cases<Real>;
  std::vector<CanaryGroup<Real>> groups{
      finite_arithmetic<Real>(),
      group<Real>(P::order, {CANARY_ORDER, CANARY_LARGER, CANARY_SMALLER}, &C::order),
      group<Real>(P::conversions, {CANARY_TRUNCATED, CANARY_FROM_UINT}, &C::conversions),
      group<Real>(P::nan_compares, {CANARY_ORDER, CANARY_LARGER, CANARY_SMALLER}, &C::with_nan),
      group<Real>(P::infinities, {CANARY_SUM, CANARY_DIFFERENCE, CANARY_PRODUCT, CANARY_QUOTIENT, CANARY_ORDER},
                  &C::infinities),
      group<Real>(P::sums, {CANARY_SUM, CANARY_DIFFERENCE, CANARY_SUM_ERROR}, &C::sums),
      group<Real>(P::contraction, {CANARY_PRODUCT_PLUS, CANARY_PRODUCTS_DIFFERENCE}, &C::contraction),
      group<Real>(P::products, {CANARY_PRODUCT, CANARY_PRODUCT_ERROR, CANARY_FMA, CANARY_DIFFERENCE_OF_PRODUCTS},
                  &C::products),
      group<Real>(P::division, {CANARY_QUOTIENT}, &C::division),
      group<Real>(P::square_root, {CANARY_ROOT}, &C::square_root),
      group<Real>(P::denormals,
                  {CANARY_SUM, CANARY_DIFFERENCE, CANARY_PRODUCT, CANARY_QUOTIENT, CANARY_ORDER, CANARY_LARGER},
                  &C::denormals),
      group<Real>(P::fma_denormals, {CANARY_FMA}, &C::fma_denormals),
  };
  constexpr Real infinity = std::numeric_limits<Real>::infinity(), nan = std::numeric_limits<Real>::quiet_NaN();
  groups.push_back({P::literal_zeros,
                    {CANARY_ZERO_TIMES, CANARY_ZERO_PLUS},
                    {{infinity, 1, 1, 1}, {nan, 1, 1, 1}, {Real(-0.0), 1, 1, 1}, {Real(-1), 1, 1, 1}}});
  groups.push_back({P::builtin_min_max,
                    {CANARY_BUILTIN_MIN, CANARY_BUILTIN_MAX},
                    {{nan, 1, 1, 1}, {1, nan, 1, 1}, {Real(-0.0), 0, 1, 1}, {2, 1, 1, 1}}});
  return groups;
}

template <typename Real>
Real canary_expected(int output, const CanaryCase<Real>& input) {
  const auto [a, b, c, d] = input;
  switch (output) {
    case CANARY_SUM:
      return a + b;
    case CANARY_SUM_ERROR: {
      const Real sum = a + b, of_b = sum - a;
      return (a - (sum - of_b)) + (b - of_b);
    }
    case CANARY_DIFFERENCE:
      return a - b;
    case CANARY_PRODUCT:
      return a * b;
    case CANARY_PRODUCT_ERROR:
      return std::fma(a, b, -(a * b));
    case CANARY_PRODUCT_PLUS:
      return a * b + c;
    case CANARY_PRODUCTS_DIFFERENCE:
      return a * b - c * d;
    case CANARY_DIFFERENCE_OF_PRODUCTS:
      return std::fma(a, b, -(c * d)) + std::fma(-c, d, c * d);
    case CANARY_QUOTIENT:
      return a / b;
    case CANARY_ROOT:
      return std::sqrt(a);
    case CANARY_FMA:
      return std::fma(a, b, c);
    // The dialect's own max_w and min_w: a NaN a is dropped.
    case CANARY_LARGER:
      return b < a ? a : b;
    case CANARY_SMALLER:
      return a < b ? a : b;
    case CANARY_ORDER:
      return static_cast<Real>((a < b ? 1 : 0) + (a <= b ? 2 : 0) + (a == b ? 4 : 0));
    case CANARY_TRUNCATED:
    case CANARY_FROM_UINT:
      return std::trunc(a);
    case CANARY_ZERO_TIMES:
      return a * Real(0);
    case CANARY_ZERO_PLUS:
      return a + Real(0);
    case CANARY_BUILTIN_MIN:
      return std::fmin(a, b);
    default:
      return std::fmax(a, b);
  }
}

template std::vector<CanaryGroup<float>> canary_groups<float>();
template std::vector<CanaryGroup<double>> canary_groups<double>();
template float canary_expected<float>(int, const CanaryCase<float>&);
template double canary_expected<double>(int, const CanaryCase<double>&);

}  // namespace strahl
