// SPDX-License-Identifier: MIT
#include "render/film.h"

#include <cmath>

#include "device/cl_layout.h"

namespace strahl {

FilmSums::FilmSums(int w, int h, int parts, double units) : width(w), height(h), sub_sums(parts), scale(units) {
  const std::size_t pixels = static_cast<std::size_t>(w) * static_cast<std::size_t>(h);
  sums.resize(pixels * sums_per_pixel(), 0);
  samples.resize(pixels, 0);
}

std::size_t FilmSums::sums_per_pixel() const { return static_cast<std::size_t>(sub_sums) * layout::FILM_CHANNELS; }

void FilmSums::add_samples(const Launch& launch) {
  for (int y = launch.row_first; y < launch.row_first + launch.rows; ++y) {
    int* row = &samples[static_cast<std::size_t>(y) * static_cast<std::size_t>(width)];
    for (int x = launch.column_first; x < launch.column_first + launch.columns; ++x) row[x] += launch.samples;
  }
}

void FilmSums::add_sums(int row, const std::vector<std::int64_t>& band) {
  std::int64_t* out = &sums[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) * sums_per_pixel()];
  for (const std::int64_t sum : band) *out++ += sum;
}

double FilmSums::sub_sum(std::size_t pixel, int sub, int channel) const {
  const std::size_t at = pixel * sums_per_pixel() + static_cast<std::size_t>(sub * layout::FILM_CHANNELS + channel);
  return static_cast<double>(sums[at]) / scale;
}

Image FilmSums::mean() const {
  Image image;
  image.width = width;
  image.height = height;
  image.data.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3, 0.0F);
  const std::int64_t* pixel = sums.data();
  float* out = image.data.data();
  for (const int count : samples) {
    const double unit = count > 0 ? 1.0 / (scale * count) : 0.0;
    for (int channel = 0; channel < layout::FILM_CHANNELS; ++channel) {
      // In halves: exact, so that it does not matter which sub-sum a sample is in.
      std::int64_t high = 0, low = 0;
      for (int sub = 0; sub < sub_sums; ++sub) {
        const std::int64_t sum = pixel[sub * layout::FILM_CHANNELS + channel];
        high += sum >> 32;
        low += sum & 0xffffffff;
      }
      const double total = std::ldexp(static_cast<double>(high), 32) + static_cast<double>(low);
      *out++ = static_cast<float>(total * unit);
    }
    pixel += sums_per_pixel();
  }
  return image;
}

}  // namespace strahl
