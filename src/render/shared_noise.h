// SPDX-License-Identifier: MIT
// How much of their noise neighbouring pixels have in common, where samples count in all pixels that the filter
// reaches.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace strahl {

/// Sums over pixels of products of z, the product of two independent differences of a pixel's sums (error_law.h). Of
/// pixels p and q the expectation of z_p z_q is their squared covariance.
struct SharedNoise {
  double own = 0;  ///< z_p^2.
  double left = 0, above = 0;

  void operator+=(const SharedNoise& other) {
    own += other.own;
    left += other.left;
    above += other.above;
  }
  /// The variance of a sum over pixels of z over that of independent pixels: the sum of the squared correlations of a
  /// pixel's noise with each pixel's, as a product of two axes. most: what it would be of samples with independent
  /// noise (packing/filter_overlap.h). Noise at edges has less in common.
  [[nodiscard]] double overlap(double most) const;
};

/// Pixels' z, row by row and from the left.
template <std::size_t number>
class SharedNoiseRows {
 public:
  using Products = std::array<double, number>;

  explicit SharedNoiseRows(std::size_t width) : row_(width) {}
  /// Column x of the next row, or of the first.
  SharedNoise add(std::size_t x, const Products& here) {
    SharedNoise noise;
    for (std::size_t k = 0; k < number; ++k) {
      noise.own += here[k] * here[k];
      if (x > 0) noise.left += here[k] * row_[x - 1][k];
      noise.above += here[k] * row_[x][k];
    }
    row_[x] = here;
    return noise;
  }

 private:
  std::vector<Products> row_;  ///< Of this row up to the last pixel, of the one above from there on.
};

}  // namespace strahl
