// SPDX-License-Identifier: MIT
#include "render/film_rows.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "packing/cl_layout.h"
#include "render/film_sum.h"

namespace strahl {
namespace {

constexpr std::size_t channels = layout::FILM_CHANNELS;

/// Halves of words of weights are in [-half_lift, 2^32 - half_lift).
constexpr std::uint32_t half_lift = 1U << 30U;
constexpr std::uint64_t lift_of_halves = (std::uint64_t{half_lift} << 32U) + half_lift;

}  // namespace

std::size_t words_per_sum(FilmKind kind) {
  if (kind == FilmKind::splats) return layout::SPLAT_WORDS;
  return layout::FILM_SUM_WORDS;
}

std::size_t FilmShape::words_per_pixel() const {
  const std::size_t more = (has_own ? static_cast<std::size_t>(sums.count) : 0) + (has_squares ? 1 : 0);
  return words_of_sums() + more * channels * layout::FILM_SUM_WORDS + words_of_weights();
}

std::size_t FilmShape::words_of_weights() const {
  if (!has_weights) return 0;
  return (static_cast<std::size_t>(sums.count) + 1) / 2;
}

std::size_t FilmShape::words_of_sums() const {
  return static_cast<std::size_t>(sums.count) * channels * words_per_sum(kind);
}

FilmRows FilmRows::below_first() const {
  const auto columns = static_cast<std::size_t>(width);
  FilmRows below{*this, words.subspan(columns * words_per_pixel()), samples.subspan(columns)};
  --below.height;
  return below;
}

SubSumColours FilmRows::sub_sums(std::size_t pixel) const {
  const std::size_t step = words_per_sum(kind);
  const std::int64_t* at = &words[pixel * words_per_pixel()];
  SubSumColours colours;
  for (auto& colour : colours)
    for (double& value : colour) {
      value = unit * (kind == FilmKind::splats ? value_of_splats(at) : value_of(film_bins(at[0], at[1])));
      at += step;
    }
  return colours;
}

double FilmRows::own_sum(std::size_t pixel, int sub, int channel) const {
  if (!has_own) return 0;
  const auto sum = static_cast<std::size_t>(sub * layout::FILM_CHANNELS + channel);
  const std::int64_t* at = &words[pixel * words_per_pixel() + words_of_sums() + sum * layout::FILM_SUM_WORDS];
  return unit * value_of(film_bins(at[0], at[1]));
}

SubSumWeights FilmRows::sub_sum_weights(std::size_t pixel) const {
  SubSumWeights weights{};
  if (!has_weights || are_counts_weights) {
    for (int sub = 0; sub < layout::FILM_SUBSUMS; ++sub)
      weights[static_cast<std::size_t>(sub)] =
          sub_sum_size(sums, sub, first_sample + samples[pixel]) - sub_sum_size(sums, sub, first_sample);
    return weights;
  }
  const std::int64_t* const words_of_pixel = &words[(pixel + 1) * words_per_pixel() - words_of_weights()];
  if (sums.count == 1) {
    weights[0] = static_cast<double>(words_of_pixel[0]) * film_weight_unit;
    return weights;
  }
  for (std::size_t sub = 0; sub < static_cast<std::size_t>(sums.count); ++sub) {
    const std::uint64_t both = static_cast<std::uint64_t>(words_of_pixel[sub / 2]) + lift_of_halves;
    const auto half = static_cast<std::uint32_t>(sub % 2 == 0 ? both : both >> 32U);
    weights[sub] = (static_cast<double>(half) - half_lift) * film_weight_unit;
  }
  return weights;
}

double FilmRows::total_weight(std::size_t pixel) const {
  if (!has_weights) return samples[pixel];
  const SubSumWeights weights = sub_sum_weights(pixel);
  return std::accumulate(weights.begin(), weights.end(), 0.0);
}

void FilmRows::put_mean(std::size_t first, double paths, Image& image) const {
  const std::int64_t* pixel = words.data();
  float* out = &image.data[first * channels];
  const bool has_splats = kind == FilmKind::splats;
  const std::size_t step = words_per_pixel();
  for (std::size_t at = 0; at < samples.size(); ++at, pixel += step, out += channels) {
    const double weight = has_splats ? paths : total_weight(at);
    if (!(weight > 0)) continue;
    Totals mean = has_splats ? splats_of(pixel) : samples_of(pixel);
    for (double& value : mean) value /= weight;
    if (has_own && samples[at] > 0) {
      const Totals total = samples_of(pixel + words_of_sums());
      for (std::size_t channel = 0; channel < channels; ++channel) mean[channel] += total[channel] / samples[at];
    }
    for (std::size_t channel = 0; channel < channels; ++channel)
      out[channel] = static_cast<float>(mean[channel] * unit);
  }
}

void FilmRows::put_squares(std::size_t first, Image& image) const {
  constexpr std::size_t per_sum = layout::FILM_SUM_WORDS;
  const std::int64_t* sum = words.data() + words_of_sums();
  float* out = &image.data[first * channels];
  for (std::size_t at = 0; at < samples.size(); ++at, sum += words_per_pixel()) {
    const double weight = total_weight(at);
    for (std::size_t channel = 0; channel < channels; ++channel, ++out) {
      const std::int64_t* bins = sum + channel * per_sum;
      if (weight > 0) *out = static_cast<float>(value_of(film_bins(bins[0], bins[1])) / weight * unit * unit);
    }
  }
}

FilmRows::Totals FilmRows::splats_of(const std::int64_t* first) const {
  constexpr std::size_t row = channels * layout::SPLAT_WORDS;
  std::array<std::int64_t, row> all{};
  for (int sub = 0; sub < sums.count; ++sub, first += row)
    for (std::size_t k = 0; k < row; ++k) all[k] += first[k];
  Totals totals;
  for (std::size_t channel = 0; channel < totals.size(); ++channel)
    totals[channel] = value_of_splats(&all[channel * layout::SPLAT_WORDS]);
  return totals;
}

/// Added up as the film adds, so that it does not matter which sub-sum a sample is in.
FilmRows::Totals FilmRows::samples_of(const std::int64_t* pixel) const {
  constexpr std::size_t row = channels * layout::FILM_SUM_WORDS;
  constexpr std::int64_t top = 3;  // The bits of a word that are not pieces.
  std::array<std::int64_t, row> all;
  std::copy_n(pixel, row, all.begin());
  std::int64_t unlike = 0;
  const std::int64_t* more = pixel;
  for (int sub = 1; sub < sums.count; ++sub) {
    more += row;
    for (std::size_t k = 0; k < row; ++k) {
      unlike |= (more[k] ^ pixel[k]) & top;
      all[k] += more[k] & ~top;
    }
  }
  if (unlike != 0) {  // Seldom: some of the sums begin in another bin.
    std::copy_n(pixel, row, all.begin());
    more = pixel;
    for (int sub = 1; sub < sums.count; ++sub) {
      more += row;
      for (std::size_t k = 0; k < row; k += layout::FILM_SUM_WORDS) film_add(&all[k], film_bins(more[k], more[k + 1]));
    }
  }
  Totals totals;
  for (std::size_t channel = 0; channel < totals.size(); ++channel) {
    const std::size_t k = channel * layout::FILM_SUM_WORDS;
    totals[channel] = value_of(film_bins(all[k], all[k + 1]));
  }
  return totals;
}

}  // namespace strahl
