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

void FilmSums::add_samples(const Launch& launch) {
  for (int y = launch.row_first; y < launch.row_first + launch.rows; ++y) {
    int* row = &samples[static_cast<std::size_t>(y) * static_cast<std::size_t>(width)];
    for (int x = launch.column_first; x < launch.column_first + launch.columns; ++x) row[x] += launch.samples;
  }
}

void FilmSums::add_words(int row, const std::vector<std::int64_t>& band) {
  std::int64_t* sum = &words[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) * words_per_pixel()];
  // Those of the pixels of splats first, then those of the film's own kind.
  const std::size_t splats = kind == FilmKind::splats ? words_of_sums() : 0;
  for (std::size_t pixel = 0; pixel < band.size(); pixel += words_per_pixel()) {
    const std::size_t own = pixel + splats, end = pixel + words_per_pixel(), weights = end - words_of_weights();
    for (std::size_t i = pixel; i < own; ++i) sum[i] += band[i];
    for (std::size_t i = own; i < weights; i += layout::FILM_SUM_WORDS)
      film_add(sum + i, film_bins(band[i], band[i + 1]));
    // Two in a word, of which the low one never carries. The high one is unsigned, too.
    for (std::size_t i = weights; i < end; ++i)
      sum[i] = static_cast<std::int64_t>(static_cast<std::uint64_t>(sum[i]) + static_cast<std::uint64_t>(band[i]));
  }
}

FilmRows FilmSums::rows(int row, int count) const {
  const auto columns = static_cast<std::size_t>(width);
  const std::size_t first = static_cast<std::size_t>(row) * columns, pixels = static_cast<std::size_t>(count) * columns;
  FilmRows some{*this, {}, std::span(samples).subspan(first, pixels)};
  some.height = count;
  if (!words.empty()) some.words = std::span(words).subspan(first * words_per_pixel(), pixels * words_per_pixel());
  return some;
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

double FilmSums::paths_a_pixel() const {
  if (kind != FilmKind::splats) return 0;
  return std::accumulate(samples.begin(), samples.end(), 0.0) / static_cast<double>(samples.size());
}

Image FilmSums::mean() const {
  Image image = black();
  rows().put_mean(0, paths_a_pixel(), image);
  return image;
}

Image FilmSums::mean_of_squares() const {
  Image image = black();
  rows().put_squares(0, image);
  return image;
}

}  // namespace strahl
