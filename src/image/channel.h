// SPDX-License-Identifier: MIT
// One channel of a picture in double precision.
#pragma once

#include <cstddef>
#include <vector>

#include "image/image.h"

namespace strahl {

/// width x height values, row 0 on top.
struct Channel {
  Channel(int columns, int rows)
      : width(columns), height(rows), values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}

  [[nodiscard]] double* row(int y) { return values.data() + static_cast<std::ptrdiff_t>(y) * width; }
  [[nodiscard]] const double* row(int y) const { return values.data() + static_cast<std::ptrdiff_t>(y) * width; }
  [[nodiscard]] double mean() const;  ///< A sum a row keeps the rounding error small.

  int width, height;
  std::vector<double> values;
};

[[nodiscard]] Channel channel_of(const Image& image, int index);

}  // namespace strahl
