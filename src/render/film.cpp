// SPDX-License-Identifier: MIT
#include "render/film.h"

#include <numeric>

#include "packing/cl_layout.h"
#include "render/film_sum.h"

namespace strahl {

FilmSums::FilmSums(const FilmShape& shape, bool holds_words) : FilmShape(shape) {
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (holds_words) words.resize(pixels * words_per_pixel(), 0);
  samples.resize(pixels, 0);
}

std::size_t words_per_sum(FilmKind kind) {
  if (kind == FilmKind::splats) return layout::SPLAT_WORDS;
  return layout::FILM_SUM_WORDS;
}

std::size_t FilmShape::words_per_pixel() const {
  return static_cast<std::size_t>(sums.count + (has_squares ? 1 : 0)) * layout::FILM_CHANNELS * words_per_sum(kind);
}

void FilmSums::add_samples(const Launch& launch) {
  for (int y = launch.row_first; y < launch.row_first + launch.rows; ++y) {
    int* row = &samples[static_cast<std::size_t>(y) * static_cast<std::size_t>(width)];
    for (int x = launch.column_first; x < launch.column_first + launch.columns; ++x) row[x] += launch.samples;
  }
}

void FilmSums::add_words(int row, const std::vector<std::int64_t>& band) {
  std::int64_t* sum = &words[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) * words_per_pixel()];
  if (kind == FilmKind::splats) {
    for (std::size_t i = 0; i < band.size(); ++i) sum[i] += band[i];
    return;
  }
  for (std::size_t i = 0; i < band.size(); i += layout::FILM_SUM_WORDS)
    film_add(sum + i, film_bins(band[i], band[i + 1]));
}

double FilmSums::sub_sum(std::size_t pixel, int sub, int channel) const {
  const auto sum = static_cast<std::size_t>(sub * layout::FILM_CHANNELS + channel);
  const std::int64_t* at = &words[pixel * words_per_pixel() + sum * words_per_sum(kind)];
  return unit * (kind == FilmKind::splats ? value_of_splats(at) : value_of(film_bins(at[0], at[1])));
}

int FilmSums::sub_sum_samples(std::size_t pixel, int sub) const {
  return sub_sum_size(sums, sub, first_sample + samples[pixel]) - sub_sum_size(sums, sub, first_sample);
}

std::vector<Launch> FilmSums::missing(int row, int rows, int end) const {
  std::vector<Launch> all;
  for (int y = row; y < row + rows; ++y) {
    const int* has = &samples[static_cast<std::size_t>(y) * static_cast<std::size_t>(width)];
    for (int x = 0, past; x < width; x = past) {
      for (past = x + 1; past < width && has[past] == has[x];) ++past;
      const int next = first_sample + has[x];
      if (next >= end) continue;
      // A row that is whole and as far as the one above it.
      if (past - x == width && !all.empty() && all.back().columns == width && all.back().sample_first == next &&
          all.back().row_first + all.back().rows == y)
        ++all.back().rows;
      else
        all.push_back({x, y, past - x, 1, next, end - next});
    }
  }
  return all;
}

Image FilmSums::black() const {
  Image image;
  image.width = width;
  image.height = height;
  image.data.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3, 0.0F);
  return image;
}

void FilmSums::put_mean(std::span<const std::int64_t> part, std::size_t first, double paths, Image& image) const {
  const std::size_t pixels = part.size() / words_per_pixel();
  const std::size_t per_sum = words_per_sum(kind);
  const std::int64_t* pixel = part.data();
  float* out = &image.data[first * layout::FILM_CHANNELS];
  for (std::size_t at = first; at < first + pixels; ++at, pixel += words_per_pixel()) {
    const double count = kind == FilmKind::splats ? paths : samples[at];
    for (std::size_t channel = 0; channel < layout::FILM_CHANNELS; ++channel, ++out)
      if (count > 0) *out = static_cast<float>(total(pixel + channel * per_sum) / count * unit);
  }
}

void FilmSums::put_squares(std::span<const std::int64_t> part, std::size_t first, Image& image) const {
  constexpr std::size_t channels = layout::FILM_CHANNELS, per_sum = layout::FILM_SUM_WORDS;
  const std::int64_t* sum = part.data() + static_cast<std::size_t>(sums.count) * channels * per_sum;
  float* out = &image.data[first * channels];
  for (std::size_t at = first; at < first + part.size() / words_per_pixel(); ++at, sum += words_per_pixel())
    for (std::size_t channel = 0; channel < channels; ++channel, ++out) {
      const std::int64_t* bins = sum + channel * per_sum;
      if (samples[at] > 0) *out = static_cast<float>(value_of(film_bins(bins[0], bins[1])) / samples[at] * unit * unit);
    }
}

/// Added up as the film adds, so that it does not matter which sub-sum a sample is in.
double FilmSums::total(const std::int64_t* sum) const {
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

double FilmSums::paths_a_pixel() const {
  if (kind != FilmKind::splats) return 0;
  return std::accumulate(samples.begin(), samples.end(), 0.0) / static_cast<double>(samples.size());
}

Image FilmSums::mean() const {
  Image image = black();
  put_mean(words, 0, paths_a_pixel(), image);
  return image;
}

Image FilmSums::mean_of_squares() const {
  Image image = black();
  put_squares(words, 0, image);
  return image;
}

}  // namespace strahl
