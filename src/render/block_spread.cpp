// SPDX-License-Identifier: MIT
#include "render/block_spread.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

#include "render/film.h"

namespace strahl {
namespace {

constexpr std::size_t contrast_count = BlockSpread::contrasts;
constexpr int spread_channels = layout::FILM_CHANNELS;
constexpr std::size_t contrast_pairs[3][2] = {{0, 1}, {0, 2}, {1, 2}};

using SpreadColour = std::array<double, spread_channels>;

double dot(const SpreadColour& a, const SpreadColour& b) {
  double sum = 0;
  for (int c = 0; c < spread_channels; ++c) sum += a[c] * b[c];
  return sum;
}

/// Pixels that have the same number of samples.
struct PixelGroup {
  int pixels = 0;
  BlockContrasts contrasts;
};

std::array<SpreadColour, contrast_count> contrasts_of(const FilmSums& film, std::size_t pixel,
                                                      const BlockContrasts& group) {
  std::array<SpreadColour, contrast_count> z{};
  for (int block = 0; block < SampleBlocks::count; ++block)
    for (int c = 0; c < spread_channels; ++c) {
      const double sum = film.sub_sum(pixel, block, c);
      for (std::size_t k = 0; k < contrast_count; ++k) z[k][c] += group.coefficient[k][block] * sum;
    }
  return z;
}

void add(Energies& to, const Energies& from, double factor) {
  to.level.resize(std::max(to.level.size(), from.level.size()), 0.0);
  for (std::size_t l = 0; l < from.level.size(); ++l) to.level[l] += factor * from.level[l];
  to.constant += factor * from.constant;
}

/// Energies are averages over the pixels that have the contrast.
void add_energies(const FilmSums& film, const std::map<int, PixelGroup>& groups, FilmSpread& result) {
  const int most = groups.rbegin()->first;
  const int levels = std::bit_width(static_cast<unsigned>(most - 1));
  std::array<double, contrast_count> pixels{};
  double all = 0;
  for (const auto& [samples, group] : groups) {
    all += group.pixels;
    for (std::size_t k = 0; k < contrast_count; ++k) pixels[k] += group.contrasts.is_measured[k] ? group.pixels : 0;
  }
  for (const auto& [samples, group] : groups) {
    const std::array<int, SampleBlocks::count> sizes = film.blocks.sizes(samples);
    for (std::size_t k = 0; k < contrast_count; ++k) {
      if (!group.contrasts.is_measured[k]) continue;
      std::vector<WeightedSamples> weights;
      for (int block = 0; block < SampleBlocks::count; ++block) {
        const int first = film.blocks.first(block);
        weights.push_back({first, first + sizes[block], group.contrasts.coefficient[k][block]});
      }
      add(result.spread.energies[k], energies_of(weights, levels), group.pixels / pixels[k]);
    }
    add(result.spread.mean, energies_of({{0, samples, 1.0 / samples}}, levels), group.pixels / all);
  }
  for (std::size_t k = 0; k < contrast_count; ++k)
    if (pixels[k] > 0) result.spread.squares[k] /= pixels[k];
}

/// Variance of the sum of one contrast's squares over the pixels, relative to the square of that sum: 2 sum(C^2), C the
/// covariance of two channels of a pixel, as products of different contrasts tell it without bias; and how well it is
/// known (Satterthwaite 1946).
void add_variance(const std::vector<std::array<double, 3>>& products, const std::vector<std::array<double, 3>>& squares,
                  const std::array<double, contrast_count>& sums, FilmSpread& result) {
  int usable = 0;
  for (const auto& pair : contrast_pairs) usable += sums[pair[0]] * sums[pair[1]] > 0 ? 1 : 0;
  double variance = 0, variance_squared = 0;
  for (std::size_t i = 0; i < products.size(); ++i) {
    double own = 0;
    for (std::size_t j = 0; j < 3 && usable > 0; ++j) {
      const double scale = sums[contrast_pairs[j][0]] * sums[contrast_pairs[j][1]];
      if (scale > 0) own += products[i][j] / scale / usable;
    }
    // Where a single contrast is all there is, of its fourth power, which is three times that of a normal one.
    for (std::size_t k = 0; k < contrast_count && usable == 0; ++k)
      if (sums[k] > 0) own += squares[i][k] * squares[i][k] / (3 * sums[k] * sums[k]);
    variance += own;
    variance_squared += own * own;
  }
  result.spread.relative_variance = std::min(2.0, 2 * variance);  // 2: one pixel is all the noise.
  result.freedom = variance_squared > 0 ? 2 * variance * variance / variance_squared : 1;
}

}  // namespace

BlockContrasts::BlockContrasts(const SampleBlocks& blocks, int samples) {
  const std::array<int, SampleBlocks::count> sizes = blocks.sizes(samples);
  for (std::size_t k = 0; k < contrast_count; ++k) {
    const std::size_t newest = SampleBlocks::count - 1 - k;
    double before = 0;
    for (std::size_t i = 0; i < newest; ++i) before += sizes[i];
    is_measured[k] = sizes[newest] > 0 && before > 0;
    if (!is_measured[k]) continue;
    const double norm = std::sqrt(1 / before + 1.0 / sizes[newest]);
    coefficient[k][newest] = 1 / (sizes[newest] * norm);
    for (std::size_t i = 0; i < newest; ++i) coefficient[k][i] = -1 / (before * norm);
  }
}

int BlockContrasts::measured() const {
  return static_cast<int>(std::count(is_measured.begin(), is_measured.end(), true));
}

FilmSpread spread_of(const FilmSums& film) {
  FilmSpread result;
  std::map<int, PixelGroup> groups;
  for (const int samples : film.samples) {
    PixelGroup& group = groups.try_emplace(samples, PixelGroup{0, BlockContrasts(film.blocks, samples)}).first->second;
    ++group.pixels;
    if (group.contrasts.measured() == 0) return result;
  }
  std::vector<std::array<double, 3>> products(film.samples.size()), squares(film.samples.size());
  std::array<double, contrast_count> sums{};
  const auto squares_of = [&](std::size_t pixel) {
    return contrasts_of(film, pixel, groups.at(film.samples[pixel]).contrasts);
  };
  for (std::size_t i = 0; i < film.samples.size(); ++i) {
    const std::array<SpreadColour, contrast_count> z = squares_of(i);
    for (std::size_t k = 0; k < contrast_count; ++k) sums[k] += squares[i][k] = dot(z[k], z[k]);
    for (std::size_t j = 0; j < 3; ++j)
      products[i][j] = std::pow(dot(z[contrast_pairs[j][0]], z[contrast_pairs[j][1]]), 2);
  }
  add_variance(products, squares, sums, result);
  result.spread.squares = sums;
  add_energies(film, groups, result);

  // Each pixel's contrasts against the picture's: three degrees of freedom a pixel and channel.
  const auto seen = std::count_if(sums.begin(), sums.end(), [](double sum) { return sum > 0; });
  result.shares.reserve(film.samples.size() * spread_channels);
  for (std::size_t i = 0; i < film.samples.size(); ++i) {
    const std::array<SpreadColour, contrast_count> z = squares_of(i);
    for (int c = 0; c < spread_channels; ++c) {
      double share = 0;
      for (std::size_t k = 0; k < contrast_count; ++k)
        if (sums[k] > 0) share += z[k][c] * z[k][c] / sums[k] / static_cast<double>(seen);
      result.shares.push_back(static_cast<float>(share));
    }
  }
  return result;
}

}  // namespace strahl
