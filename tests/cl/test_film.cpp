// SPDX-License-Identifier: MIT
// The film's arithmetic (cl/film/film.h, film_sum.h) of both tiers on the host against exact rationals: a float comes
// back whole, order and split do not matter, what is dropped has its bound, and 2^21 samples fit. Device:
// test_functions.
#include <gmpxx.h>

#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "cl/math_tiers.h"
#include "render/film.h"
#include "render/film_sum.h"

using namespace strahl;
using namespace strahl::test;

namespace {

using Counts = std::array<std::uint32_t, 4>;

/// 2^exponent.
mpq_class power(int exponent) {
  mpq_class result = 1;
  if (exponent >= 0)
    mpq_mul_2exp(result.get_mpq_t(), result.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  else
    mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  return result;
}

mpq_class exact(const FilmWords& sum) {
  const FilmBins bins = film_bins(sum[0], sum[1]);
  const mpq_class pieces = mpq_class(bins.high) * power(FILM_BIN_BITS) + mpq_class(bins.low);
  return pieces * power((bins.top - 2) * FILM_BIN_BITS - FILM_ORIGIN);
}

void merge(FilmWords& sum, const FilmWords& other) { film_add(sum.data(), film_bins(other[0], other[1])); }

template <class Real>
FilmWords sum_of(const std::vector<Real>& values) {
  Counts counts{};
  FilmWords sum{};
  for (const Real value : values) add_to_film(sum, value, &counts);
  CHECK(counts == Counts{});
  return sum;
}

/// Of any size within `decades` about a middle, the film's whole range apart or alike; some negative, some 0.
template <class Real>
class Values {
 public:
  std::vector<Real> draw(std::size_t count, bool may_be_negative) {
    const double decades = std::array{0.0, 3.0, 12.0, 35.0, 80.0}.at(random_() % 5);
    std::uniform_real_distribution<double> middle(-20, 18), place(-decades / 2, decades / 2), digits(0.5, 1);
    const double centre = middle(random_);
    std::vector<Real> values;
    while (values.size() < count) {
      double value = digits(random_) * std::pow(10.0, std::clamp(centre + place(random_), -46.0, 38.0));
      if (random_() % 16 == 0) value = 0;
      if (may_be_negative && random_() % 2 == 0) value = -value;
      values.push_back(static_cast<Real>(value));
    }
    return values;
  }
  std::mt19937& random() { return random_; }

 private:
  std::mt19937 random_{7};
};

template <class Real>
mpq_class exact_sum(const std::vector<Real>& values) {
  mpq_class sum = 0;
  for (const Real value : values) sum += mpq_class(static_cast<double>(value));
  return sum;
}

}  // namespace

TEST_CASE("a float comes back whole, subnormal or negative, and the same from either tier") {
  std::mt19937 random(3);
  std::vector<float> values{0.0F,      -0.0F,     0x1p-149F,       -0x1p-149F, 0x1.fffffcp-127F,
                            0x1p-126F, 0x1p-127F, 0x1.fffffep127F, 0x1p-20F,   0x1.fffffep-21F,
                            0x1p20F,   1.0F,      0x1.fffffep19F,  -0x1p60F,   0x1.fffffep59F};
  while (values.size() < 300000) {
    const float value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    if (std::isfinite(value)) values.push_back(value);
  }
  for (const float value : values) {
    Counts counts{};
    FilmWords sum{}, same{};
    add_to_film(sum, value, &counts);
    add_to_film(same, static_cast<double>(value), &counts);
    // As a double it is not subnormal, so that its top may be one bin lower.
    const bool is_same = std::abs(value) < 0x1p-126F ? exact(sum) == exact(same) : sum == same;
    if (value_of(film_bins(sum[0], sum[1])) != static_cast<double>(value) || !is_same || counts != Counts{}) {
      CAPTURE(value, sum, same, counts);
      FAIL("not whole");
    }
  }
}

TEST_CASE("of a double the 41 leading bits stay, cut towards 0") {
  std::mt19937_64 random(3);
  for (int i = 0; i < 100000; ++i) {
    // Exponents of the film's range, both signs.
    const std::uint64_t exponent = 1023 - 149 + random() % 277;
    const auto value = std::bit_cast<double>((random() >> 12) | exponent << 52 | (random() & 1) << 63);
    Counts counts{};
    FilmWords sum{};
    add_to_film(sum, value, &counts);
    const mpq_class held = exact(sum), size = abs(mpq_class(value));
    if (!(sgn(held) == (value < 0 ? -1 : 1) && abs(held) <= size && size - abs(held) < size * power(-40))) {
      CAPTURE(value, held.get_d());
      FAIL("cut off too much");
    }
    REQUIRE(counts == Counts{});
  }
  FilmWords nothing{};
  Counts counts{};
  for (const double small : {1e-60, -1e-300, 5e-324}) add_to_film(nothing, small, &counts);
  CHECK(nothing == FilmWords{});
  CHECK(counts == Counts{});
}

TEMPLATE_TEST_CASE("order and split do not matter", "", float, double) {
  Values<TestType> values;
  std::mt19937& random = values.random();
  for (int trial = 0; trial < 3000; ++trial) {
    std::vector<TestType> samples = values.draw(std::array{1, 4, 64, 1000}.at(random() % 4), trial % 2 == 0);
    const FilmWords expected = sum_of(samples);
    std::shuffle(samples.begin(), samples.end(), random);
    std::vector<FilmWords> parts(1 + random() % 7, FilmWords{});
    Counts counts{};
    for (const TestType sample : samples) add_to_film(parts.at(random() % parts.size()), sample, &counts);
    while (parts.size() > 1) {
      const std::size_t at = random() % (parts.size() - 1);
      merge(parts[at], parts.back());
      parts.pop_back();
    }
    REQUIRE(parts[0] == expected);
  }
}

TEMPLATE_TEST_CASE("what is cut in floating point is what integers cut", "", float, double) {
  Values<TestType> values;
  for (int trial = 0; trial < 3000; ++trial) {
    FilmWords sum{}, same{};
    Counts counts{};
    for (const TestType value : values.draw(20, trial % 2 == 0)) {
      add_to_film(sum, value, &counts);
      add_by_integers(same, value, 1);
      REQUIRE(sum == same);
    }
  }
  FilmWords once{}, often{};
  add_by_integers(once, TestType(0.1), 4095);
  Counts counts{};
  for (int i = 0; i < 4095; ++i) add_to_film(often, TestType(0.1), &counts);
  CHECK(once == often);
}

TEMPLATE_TEST_CASE("each sample loses less than 2^-40 of the largest: 4096 less than 2^-28 of their sum", "", float,
                   double) {
  Values<TestType> values;
  for (int trial = 0; trial < 200; ++trial) {
    const std::size_t count = trial % 8 == 0 ? 4096 : 64;
    const bool may_be_negative = trial % 2 == 1;
    const std::vector<TestType> samples = values.draw(count, may_be_negative);
    TestType largest = 0;
    for (const TestType sample : samples) largest = std::max(largest, std::abs(sample));
    const mpq_class truth = exact_sum(samples), lost = abs(exact(sum_of(samples)) - truth);
    if (lost == 0) continue;
    CAPTURE(trial, count, largest, lost.get_d(), truth.get_d());
    REQUIRE(lost < mpq_class(static_cast<double>(count)) * mpq_class(static_cast<double>(largest)) * power(-40));
    if (!may_be_negative) REQUIRE(lost < truth * power(-28));
  }
}

TEMPLATE_TEST_CASE("2^21 samples of the largest pieces fit, in one sum or in four, of either sign", "", float, double) {
  const TestType ones = std::nextafter(TestType(2), TestType(0));
  // At either end of a bin: nearly all of it in the upper piece, and nearly all in the lower.
  for (const int exponent : {19, 20, -21, 127})
    for (const int sign : {1, -1}) {
      const TestType value =
          static_cast<TestType>(sign) * std::ldexp(exponent == 127 ? TestType(0x1.fffffep0) : ones, exponent);
      std::array<FilmWords, 4> subs{};
      Counts counts{};
      FilmWords one{};
      add_to_film(one, value, &counts);
      for (int i = 0; i < 1 << 21; ++i) add_to_film(subs[i & 3], value, &counts);
      for (std::size_t k = 1; k < 4; ++k) merge(subs[0], subs[k]);
      CAPTURE(value);
      CHECK(exact(subs[0]) == exact(one) * power(21));
      CHECK(counts == Counts{});
    }
}

TEMPLATE_TEST_CASE("NaN counts as 0, what is beyond a float as the largest, and both are told", "", float, double) {
  using Limits = std::numeric_limits<TestType>;
  constexpr double most = std::numeric_limits<float>::max();
  const auto added = [](TestType value, Counts& counts) {
    FilmWords sum{};
    add_to_film(sum, value, &counts);
    return value_of(film_bins(sum[0], sum[1]));
  };
  Counts counts{};
  CHECK(added(static_cast<TestType>(most), counts) == most);
  CHECK(counts == Counts{});
  CHECK(added(Limits::infinity(), counts) == most);
  CHECK(added(-Limits::infinity(), counts) == -most);
  CHECK(counts == Counts{2, 0, 0, 0});
  CHECK(added(Limits::quiet_NaN(), counts) == 0);
  CHECK(added(-Limits::quiet_NaN(), counts) == 0);
  CHECK(added(Limits::signaling_NaN(), counts) == 0);
  CHECK(counts == Counts{2, 3, 0, 0});
  if (Limits::digits > 24) {
    CHECK(added(static_cast<TestType>(0x1.ffffffp127), counts) == most);
    CHECK(added(Limits::max(), counts) == most);
    CHECK(counts == Counts{4, 3, 0, 0});
  }
}

TEST_CASE("the host counts the samples of a sub-sum as the device deals them out") {
  for (const SubSums sums :
       {SubSums{1, 1, 0}, SubSums{4, 4, 0}, SubSums{4, 2, 0}, SubSums{4, 2, 2}, SubSums{4, 2, 5}}) {
    std::array<int, 4> dealt{};
    for (int samples = 0; samples < 200; ++samples) {
      for (int sub = 0; sub < sums.count; ++sub)
        CHECK(sub_sum_size(sums, sub, samples) == dealt[static_cast<std::size_t>(sub)]);
      const int sub = sub_sum_of(sums, samples);
      CHECK(sub % sums.sequences == samples % sums.sequences);
      ++dealt[static_cast<std::size_t>(sub)];
    }
  }
}

TEST_CASE("a sequence's sums are its halves") {
  const SubSums sums{4, 2, 3};
  for (int sample = 0; sample < 32; ++sample) CHECK(sub_sum_of(sums, sample) == sample % 2 + (sample < 16 ? 0 : 2));
}

TEST_CASE("bands and sub-sums add up to one mean") {
  std::mt19937 random(11);
  FilmSums four({FilmKind::pixels, 3, 2, {4, 4, 0}}), one({FilmKind::pixels, 3, 2, {1, 1, 0}});
  Values<float> values;
  for (std::size_t pixel = 0; pixel < 6; ++pixel) {
    const std::vector<float> samples = values.draw(64, false);
    one.samples[pixel] = four.samples[pixel] = 64;
    for (std::size_t i = 0; i < samples.size(); ++i)
      for (std::size_t channel = 0; channel < 3; ++channel) {
        Counts counts{};
        FilmWords word{};
        add_to_film(word, samples[(i + 7 * channel) % 64], &counts);
        film_add(&one.words[(pixel * 3 + channel) * 2], film_bins(word[0], word[1]));
        film_add(&four.words[((pixel * 4 + i % 4) * 3 + channel) * 2], film_bins(word[0], word[1]));
      }
    double sum = 0;
    for (const auto& colour : four.rows().sub_sums(pixel)) sum += colour[1];
    CHECK(sum == Approx(exact_sum(samples).get_d()).epsilon(1e-12));
  }
  CHECK(one.mean().data == four.mean().data);
  FilmSums again({FilmKind::pixels, 3, 2, {4, 4, 0}});
  again.samples = four.samples;
  const auto row = static_cast<std::ptrdiff_t>(3 * four.words_per_pixel());
  again.add_words(1, {four.words.begin() + row, four.words.end()});
  again.add_words(0, {four.words.begin(), four.words.begin() + row});
  CHECK(again.words == four.words);
}

TEST_CASE("a pixel whose samples are alike is that sample, to the bit") {
  for (const float value : {1.0F, 0.1F, 3.3e-41F, 1e13F, 3.4e38F})
    for (const int count : {1, 3, 7, 4095, 1 << 21}) {
      FilmSums film({FilmKind::pixels, 1, 1, {1, 1, 0}});
      film.samples[0] = count;
      FilmWords word{};
      Counts counts{};
      add_to_film(word, value, &counts);
      FilmBins bins = film_bins(word[0], word[1]);
      bins.high *= count;
      bins.low *= count;
      film_add(film.words.data(), bins);
      CHECK(film.mean().data[0] == value);
    }
}
