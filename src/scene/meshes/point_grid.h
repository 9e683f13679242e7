// SPDX-License-Identifier: MIT
// Points of the plane in square cells, about as many as there are points, so that those in a box are found without a
// look at all others.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "scene/model/vec.h"

namespace strahl {

class PointGrid {
 public:
  /// Of those points that `numbers` names. points: finite, at least one.
  PointGrid(const std::vector<Vec2>& points, const std::vector<int>& numbers)
      : low_(points.front()), high_(points.front()), numbers_(numbers.size()) {
    const auto point = [&](int number) { return points[static_cast<std::size_t>(number)]; };
    for (const Vec2& p : points) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
    }
    side_ = std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(static_cast<double>(numbers.size()))));
    begins_.assign(side_ * side_ + 1, 0);
    for (const int number : numbers) ++begins_[cell_of(point(number)) + 1];
    for (std::size_t i = 1; i < begins_.size(); ++i) begins_[i] += begins_[i - 1];
    std::vector<std::size_t> next(begins_.begin(), begins_.end() - 1);
    for (const int number : numbers) numbers_[next[cell_of(point(number))]++] = number;
  }

  /// Whether `is` holds of a point, told by its number, in the closed box. It may also be asked of points nearby.
  template <class Predicate>
  [[nodiscard]] bool any_in(const Vec2& low, const Vec2& high, Predicate is) const {
    const std::size_t left = column(low.x), right = column(high.x);
    for (std::size_t y = row(low.y), last = row(high.y); y <= last; ++y) {
      const std::size_t begin = begins_[y * side_ + left], end = begins_[y * side_ + right + 1];
      for (std::size_t i = begin; i < end; ++i)
        if (is(numbers_[i])) return true;
    }
    return false;
  }

 private:
  /// Rises with x, whatever is rounded, so that no point of a box is missed.
  [[nodiscard]] std::size_t place(double x, double low, double high) const {
    if (!(high > low)) return 0;
    const double share = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return std::min(static_cast<std::size_t>(share * static_cast<double>(side_)), side_ - 1);
  }
  [[nodiscard]] std::size_t column(double x) const { return place(x, low_.x, high_.x); }
  [[nodiscard]] std::size_t row(double y) const { return place(y, low_.y, high_.y); }
  [[nodiscard]] std::size_t cell_of(const Vec2& p) const { return row(p.y) * side_ + column(p.x); }

  Vec2 low_, high_;
  std::size_t side_ = 1;
  std::vector<std::size_t> begins_;  ///< Of each cell in numbers_, row by row, and the end.
  std::vector<int> numbers_;         ///< Of the points, cell by cell.
};

}  // namespace strahl
