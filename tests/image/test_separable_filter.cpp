// SPDX-License-Identifier: MIT
// The filter in two passes against sums over neighbours, written down without any speed.
#include <catch2/catch.hpp>

#include "image/separable_filter.h"

using namespace strahl;

namespace {

int beyond(int index, int size, Border border) {
  while (index < 0 || index >= size) {
    if (border == Border::repeat) index = index < 0 ? 0 : size - 1;
    if (border == Border::mirror) index = index < 0 ? -1 - index : 2 * size - 1 - index;
  }
  return index;
}

Channel sample(int width, int height) {
  Channel channel(width, height);
  for (std::size_t i = 0; i < channel.values.size(); ++i) channel.values[i] = static_cast<double>((i * i * 7 + i) % 23);
  return channel;
}

}  // namespace

TEST_CASE("rows and columns are filtered with either border") {
  const std::vector<double> weights{1, 2, 4, 8, 16, 32, 64};  // Integers: sums without rounding.
  for (const Border border : {Border::mirror, Border::repeat}) {
    for (const auto& [width, height] : {std::pair{9, 7}, {2, 11}, {1, 1}, {8, 2}}) {
      const Channel channel = sample(width, height);
      const Channel rows = filter_rows(channel, weights, border);
      const Channel columns = filter_columns(channel, weights, border);
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          double along_x = 0;
          double along_y = 0;
          for (int k = -3; k <= 3; ++k) {
            const double weight = weights[static_cast<std::size_t>(k + 3)];
            along_x += weight * channel.row(y)[beyond(x + k, width, border)];
            along_y += weight * channel.row(beyond(y + k, height, border))[x];
          }
          CHECK(rows.row(y)[x] == along_x);
          CHECK(columns.row(y)[x] == along_y);
        }
      }
    }
  }
}
