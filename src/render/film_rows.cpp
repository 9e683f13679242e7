// SPDX-License-Identifier: MIT
#include "render/film_rows.h"

#include "packing/cl_layout.h"
#include "render/film_sum.h"

namespace strahl {

std::size_t words_per_sum(FilmKind kind) {
  if (kind == FilmKind::splats) return layout::SPLAT_WORDS;
  return layout::FILM_SUM_WORDS;
}

std::size_t FilmShape::words_per_pixel() const {
  return static_cast<std::size_t>(sums.count + (has_squares ? 1 : 0)) * layout::FILM_CHANNELS * words_per_sum(kind);
}

double FilmRows::sub_sum(std::size_t pixel, int sub, int channel) const {
  const auto sum = static_cast<std::size_t>(sub * layout::FILM_CHANNELS + channel);
  const std::int64_t* at = &words[pixel * words_per_pixel() + sum * words_per_sum(kind)];
  return unit * (kind == FilmKind::splats ? value_of_splats(at) : value_of(film_bins(at[0], at[1])));
}

int FilmRows::sub_sum_samples(std::size_t pixel, int sub) const {
  return sub_sum_size(sums, sub, first_sample + samples[pixel]) - sub_sum_size(sums, sub, first_sample);
}

void FilmRows::put_mean(std::size_t first, double paths, Image& image) const {
  const std::size_t per_sum = words_per_sum(kind);
  const std::int64_t* pixel = words.data();
  float* out = &image.data[first * layout::FILM_CHANNELS];
  for (std::size_t at = 0; at < samples.size(); ++at, pixel += words_per_pixel()) {
    const double count = kind == FilmKind::splats ? paths : samples[at];
    for (std::size_t channel = 0; channel < layout::FILM_CHANNELS; ++channel, ++out)
      if (count > 0) *out = static_cast<float>(total(pixel + channel * per_sum) / count * unit);
  }
}

void FilmRows::put_squares(std::size_t first, Image& image) const {
  constexpr std::size_t channels = layout::FILM_CHANNELS, per_sum = layout::FILM_SUM_WORDS;
  const std::int64_t* sum = words.data() + static_cast<std::size_t>(sums.count) * channels * per_sum;
  float* out = &image.data[first * channels];
  for (std::size_t at = 0; at < samples.size(); ++at, sum += words_per_pixel())
    for (std::size_t channel = 0; channel < channels; ++channel, ++out) {
      const std::int64_t* bins = sum + channel * per_sum;
      if (samples[at] > 0) *out = static_cast<float>(value_of(film_bins(bins[0], bins[1])) / samples[at] * unit * unit);
    }
}

/// Added up as the film adds, so that it does not matter which sub-sum a sample is in.
double FilmRows::total(const std::int64_t* sum) const {
  const std::size_t stride = layout::FILM_CHANNELS * words_per_sum(kind);
  if (kind == FilmKind::splats) {
    std::int64_t all[layout::SPLAT_WORDS] = {};
    for (int sub = 0; sub < sums.count; ++sub, sum += stride)
      for (int k = 0; k < layout::SPLAT_WORDS; ++k) all[k] += sum[k];
    return value_of_splats(all);
  }
  std::int64_t all[layout::FILM_SUM_WORDS] = {sum[0], sum[1]};
  for (int sub = 1; sub < sums.count; ++sub) {
    sum += stride;
    film_add(all, film_bins(sum[0], sum[1]));
  }
  return value_of(film_bins(all[0], all[1]));
}

}  // namespace strahl
