// SPDX-License-Identifier: MIT
#include "render/film_parts.h"

#include <algorithm>

#include "on_threads.h"
#include "render/error_law.h"

namespace strahl {
namespace {

constexpr std::size_t part_bytes = std::size_t{2} << 20;
constexpr std::size_t least_bands = 4;
constexpr unsigned most_threads = 8;

constexpr std::size_t quotient_up(std::size_t a, std::size_t b) { return (a + b - 1) / b; }

}  // namespace

std::vector<Rows> film_parts(int height, std::size_t row_bytes, unsigned threads) {
  const std::size_t bands = band_of(height - 1) + 1;
  const std::size_t most = std::max(least_bands, part_bytes / (row_bytes * rows_per_band));
  std::size_t count = quotient_up(bands, most);
  if (count > 1) count = std::min(bands, quotient_up(count, threads) * threads);
  std::vector<Rows> parts;
  for (std::size_t i = 0; i < count; ++i) {
    const int first = static_cast<int>(bands * i / count) * rows_per_band;
    const int end = std::min(height, static_cast<int>(bands * (i + 1) / count) * rows_per_band);
    parts.push_back({first, end - first});
  }
  return parts;
}

unsigned film_threads() { return std::min(hardware_threads(), most_threads); }

}  // namespace strahl
