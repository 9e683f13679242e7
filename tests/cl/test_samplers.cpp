// SPDX-License-Identifier: MIT
// The samplers: sobol's two sequences are (0, 2)-sequences in every set, of every pixel, and know nothing of each
// other; both samplers are uniform. 1 s.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <vector>

#include "cl/sampling_tiers.h"

using namespace strahl::test;

namespace {

using Sampler = Pair (*)(std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t);

/// Number `i` of one of the two sequences that are interleaved.
Pair of_sequence(std::uint32_t sequence, std::uint32_t i, std::uint32_t pixel, std::uint32_t set, std::uint32_t seed) {
  return sobol_pair(pixel, 2 * i + sequence, set, seed);
}

/// One point in every box of 2^-a by 2^-(m - a).
bool is_net(const std::vector<Pair>& points, unsigned m) {
  for (unsigned a = 0; a <= m; ++a) {
    std::set<std::uint64_t> boxes;
    for (const auto& [x, y] : points) {
      const std::uint64_t column = std::uint64_t{x} << a >> 32, row = std::uint64_t{y} << (m - a) >> 32;
      boxes.insert(column << 32 | row);
    }
    if (boxes.size() != points.size()) return false;
  }
  return true;
}

double unit(std::uint32_t bits) { return std::ldexp(bits + 0.5, -32); }

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - 0.5) * (b[i] - 0.5);
  return 12 * sum / static_cast<double>(a.size());
}

/// Root of the mean squared error of a smooth integral, over many pixels.
double error_of_integral(Sampler sampler, std::uint32_t samples) {
  constexpr std::uint32_t pixels = 400;
  const double truth = (std::exp(1.0) - 1) * (1 - std::cos(2.0)) / 2;
  double squares = 0;
  for (std::uint32_t pixel = 0; pixel < pixels; ++pixel) {
    double sum = 0;
    for (std::uint32_t i = 0; i < samples; ++i) {
      const auto [x, y] = sampler(pixel, i, 3, 0);
      sum += std::exp(unit(x)) * std::sin(2 * unit(y));
    }
    squares += std::pow(sum / samples - truth, 2);
  }
  return std::sqrt(squares / pixels);
}

}  // namespace

TEST_CASE("each of sobol's sequences is a (0, 2)-sequence in every set") {
  for (const std::uint32_t pixel : {0u, 1u, 786431u})
    for (const std::uint32_t set : {0u, 1u, 2u, 17u})
      for (std::uint32_t sequence = 0; sequence < 2; ++sequence)
        for (const unsigned m : {1u, 4u, 8u})
          for (const std::uint32_t first : {0u, 5u}) {
            std::vector<Pair> points;
            for (std::uint32_t i = first << m; i < (first + 1) << m; ++i)
              points.push_back(of_sequence(sequence, i, pixel, set, 7));
            CHECK(is_net(points, m));
          }
  std::vector<Pair> random;
  for (std::uint32_t i = 0; i < 16; ++i) random.push_back(independent_pair(0, i, 0, 7));
  CHECK_FALSE(is_net(random, 4));
}

TEST_CASE("where the film keeps one sum, all samples are one (0, 2)-sequence") {
  for (const std::uint32_t set : {0u, 17u})
    for (const unsigned m : {2u, 8u}) {
      std::vector<Pair> single, interleaved;
      for (std::uint32_t i = 0; i < 1u << m; ++i) {
        single.push_back(sobol_single_pair(5, i, set, 7));
        interleaved.push_back(sobol_pair(5, i, set, 7));
      }
      CHECK(is_net(single, m));
      CHECK_FALSE(is_net(interleaved, m));
    }
}

TEST_CASE("coordinates, sets, sequences, pixels and seeds know nothing of each other") {
  constexpr std::uint32_t count = 100000;
  const double most = 4.5 / std::sqrt(count);
  for (const Sampler sampler : {&sobol_pair, &independent_pair}) {
    std::vector<std::vector<double>> columns(8);
    // The same place in its sequence for every pixel: what is left is the scrambling.
    for (std::uint32_t pixel = 0; pixel < count; ++pixel) {
      const Pair pairs[] = {sampler(pixel, 8, 1, 0), sampler(pixel, 8, 2, 0), sampler(pixel, 9, 1, 0),
                            sampler(pixel, 8, 1, 1)};
      for (std::size_t k = 0; k < 8; ++k) columns[k].push_back(unit(pairs[k / 2][k % 2]));
    }
    for (std::size_t a = 0; a < columns.size(); ++a) {
      double mean = 0;
      for (const double x : columns[a]) mean += x / count;
      CHECK(std::fabs(mean - 0.5) < 4.5 * std::sqrt(1.0 / 12 / count));
      CHECK(correlation(columns[a], columns[a]) == Approx(1).margin(0.02));
      for (std::size_t b = 0; b < a; ++b) {
        INFO(a << ", " << b);
        CHECK(std::fabs(correlation(columns[a], columns[b])) < most);
      }
      std::vector<double> next(columns[a].begin() + 1, columns[a].end());
      next.push_back(columns[a][0]);
      CHECK(std::fabs(correlation(columns[a], next)) < most);
    }
  }
}

TEST_CASE("sobol converges faster than independent numbers") {
  for (const std::uint32_t samples : {16u, 64u, 256u, 1024u}) {
    const double even = error_of_integral(sobol_pair, samples), random = error_of_integral(independent_pair, samples);
    INFO(samples << " samples: " << even << " against " << random);
    CHECK(even < random * 2 / std::sqrt(samples / 4.0));
  }
  // Two sequences of n / 2: their own error falls like n^-1.5 where the integrand is smooth.
  CHECK(error_of_integral(sobol_pair, 1024) < error_of_integral(sobol_pair, 64) / 20);
  // One of n: twice the points in it, and half of the means.
  CHECK(error_of_integral(sobol_single_pair, 256) < 0.6 * error_of_integral(sobol_pair, 256));
}

TEST_CASE("numbers lie strictly between 0 and 1") {
  CHECK(Maps<float>::between(0) > 0);
  CHECK(Maps<float>::between(0xffffffff) < 1);
  CHECK(Maps<double>::between(0) > 0);
  CHECK(Maps<double>::between(0xffffffff) < 1);
  CHECK(Maps<float>::between(0x80000000) + Maps<float>::between(0x7fffffff) == 1);
}
