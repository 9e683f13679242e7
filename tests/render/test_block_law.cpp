// SPDX-License-Identifier: MIT
// The law of one sequence's blocks on made-up samples: what is exact is, mixtures of the law are told, and what is off
// it stays within what it claims. No device.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "device/cl_layout.h"
#include "render/block_spread.h"
#include "render/film.h"
#include "render/film_sum.h"

namespace strahl {
namespace {

/// Variances g by level, [0] is the finest; beyond the last they go on falling by `beyond`.
struct Spectrum {
  std::vector<double> g;
  double beyond = 1;

  double at(int level) const {
    const auto last = static_cast<int>(g.size()) - 1;
    return level <= last ? g[static_cast<std::size_t>(level)] : g.back() * std::pow(beyond, level - last);
  }
  /// Variance of sum(w y): g by the energies of w, and what follows for the rest.
  double variance(const Energies& energies) const {
    double sum = 0, factor = energies.constant;
    for (std::size_t l = 0; l < energies.level.size(); ++l) sum += energies.level[l] * at(static_cast<int>(l));
    for (int l = static_cast<int>(energies.level.size()); l < 60; ++l) sum += at(l) * (factor /= 2);
    return sum;
  }
};

Spectrum falling(double ratio, double floor = 0) {
  Spectrum spectrum{{}, ratio};
  for (int l = 0; l < 40; ++l) spectrum.g.push_back(floor + (1 - floor) * std::pow(ratio, l));
  return spectrum;
}

/// What a film of endlessly many pixels would hold.
BlockSpread expected_spread(const Spectrum& spectrum, int samples) {
  const SampleBlocks blocks = SampleBlocks::of_sequence(samples);
  const BlockContrasts contrasts(blocks, samples);
  const auto sizes = blocks.sizes(samples);
  int levels = 0;
  while (1 << levels < samples) ++levels;
  BlockSpread spread;
  for (std::size_t k = 0; k < BlockSpread::contrasts; ++k) {
    std::vector<WeightedSamples> weights;
    for (int b = 0; b < SampleBlocks::count; ++b)
      weights.push_back({blocks.first(b), blocks.first(b) + sizes[static_cast<std::size_t>(b)],
                         contrasts.coefficient[k][static_cast<std::size_t>(b)]});
    spread.energies[k] = energies_of(weights, levels);
    spread.squares[k] = spectrum.variance(spread.energies[k]);
  }
  spread.mean = energies_of({{0, samples, 1.0 / samples}}, levels);
  return spread;
}

TEST_CASE("energies add up to the squared norm") {
  const std::vector<WeightedSamples> weights{{0, 5, 0.3}, {5, 6, -2}, {6, 23, 0.1}};
  double norm = 0;
  for (const WeightedSamples& piece : weights) norm += piece.weight * piece.weight * (piece.end - piece.first);
  const Energies energies = energies_of(weights, 5);
  double sum = energies.constant;
  for (const double energy : energies.level) sum += energy;
  CHECK(sum == Approx(norm));
  // A mean of 2^m samples differs from no block to block within them.
  const Energies mean = energies_of({{0, 16, 1.0 / 16}}, 4);
  for (const double energy : mean.level) CHECK(energy == 0);
  CHECK(mean.constant == Approx(1.0 / 16));
}

TEST_CASE("blocks are an octave each, and later ones are made of whole earlier ones") {
  CHECK(SampleBlocks::of_sequence(64).sizes(64) == std::array{8, 8, 16, 32});
  CHECK(SampleBlocks::of_sequence(100).sizes(100) == std::array{16, 16, 32, 36});
  CHECK(SampleBlocks::of_sequence(4).sizes(4) == std::array{0, 1, 1, 2});
  CHECK(SampleBlocks().sizes(7) == std::array{2, 2, 2, 1});
  for (int samples = 8; samples < 300; ++samples) {
    const SampleBlocks now = SampleBlocks::of_sequence(samples), next = SampleBlocks::of_sequence(samples + 1);
    int total = 0;
    for (const int size : now.sizes(samples)) total += size;
    CHECK(total == samples);
    for (int b = 0; b < SampleBlocks::count; ++b) {
      const int last = b + 1 < SampleBlocks::count ? now.first(b + 1) - 1 : samples - 1;
      CHECK(next.of(now.first(b)) == next.of(last));
    }
  }
}

TEST_CASE("what blocks tell of a sequence that keeps the law") {
  for (const int samples : {16, 64, 100, 256, 1000, 4096})
    for (const Spectrum& spectrum : {falling(1), falling(0.75), falling(0.65), falling(0.65, 0.1)}) {
      BlockSpread spread = expected_spread(spectrum, samples);
      spread.relative_variance = 1e-4;
      const SequenceError told = sequence_error(spread);
      const double off = told.log_square - std::log(spectrum.variance(spread.mean));
      INFO(samples << " samples, g_1 / g_0 = " << spectrum.g[1] << ": " << std::exp(off / 2));
      CHECK(std::fabs(off) < 2 * std::sqrt(told.variance));
      CHECK(std::fabs(off) < 0.3);
      CHECK(told.variance < (samples < 64 ? 0.2 : 0.06));
    }
}

TEST_CASE("blocks that are few pixels' tell little, and say so") {
  BlockSpread spread = expected_spread(falling(0.7), 64);
  spread.relative_variance = 0.01;
  const double sure = sequence_error(spread).variance;
  spread.relative_variance = 1;
  CHECK(sequence_error(spread).variance > 2 * sure);
  // A contrast that happens to vanish is no proof that there is no error.
  spread.squares[0] = 0;
  CHECK(std::isfinite(sequence_error(spread).log_square));
}

/// A whole number of radiance as a sum of the film: bin 6 ends with the units of 2^-20.
void put(FilmSums& film, std::size_t sum, std::int64_t radiance) {
  film_add(&film.words[sum * layout::FILM_SUM_WORDS], {6, 0, radiance << 20});
}

TEST_CASE("pixels' shares add up, and say where the noise is") {
  FilmSums film(3, 1, SampleBlocks::count, 1);
  film.blocks = SampleBlocks::of_sequence(64);
  film.samples = {64, 63, 64};
  const std::array<int, 4> uneven{12, 4, 20, 28};
  for (std::size_t b = 0; b < 4; ++b) {
    put(film, b * 3, uneven[b] * 100);         // The first pixel's red alone varies.
    put(film, 24 + b * 3 + 2, 5 * uneven[b]);  // And the last one's blue, by less.
  }
  const FilmSpread found = spread_of(film);
  double sum = 0;
  for (const float share : found.shares) sum += static_cast<double>(share);
  CHECK(sum == Approx(1));
  CHECK(found.shares[0] == Approx(1 / (1 + 0.0025)));
  CHECK(found.shares[8] == Approx(0.0025 / (1 + 0.0025)));
  CHECK(found.shares[4] == 0);
  film.samples = {64, 8, 64};  // One block's worth of a pixel.
  CHECK(spread_of(film).shares.empty());
}

}  // namespace
}  // namespace strahl
