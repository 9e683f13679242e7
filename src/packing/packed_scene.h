// SPDX-License-Identifier: MIT
// The three buffers of cl/scene/layout.h, as they are filled.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <limits>
#include <span>
#include <vector>

#include "errors.h"
#include "packing/tree_stats.h"
#include "scene/model/vec.h"

namespace strahl {

/// Offsets are ints: a buffer holds at most 2^31 elements.
inline int checked_offset(std::size_t size) {
  if (size > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
    throw Error("the scene is too large: a device buffer would hold more than 2^31 numbers");
  return static_cast<int>(size);
}

template <typename Real>
struct PackedScene {
  std::vector<Real> geometry;
  std::vector<Real> shading;
  std::vector<std::int32_t> index;
  TreeStats tree;

  [[nodiscard]] std::size_t bytes() const {
    return (geometry.size() + shading.size()) * sizeof(Real) + index.size() * sizeof(std::int32_t);
  }

  [[nodiscard]] std::int32_t& at(int offset) { return index[static_cast<std::size_t>(offset)]; }
  [[nodiscard]] int index_end() const { return checked_offset(index.size()); }

  // Each returns the offset of what it has appended.
  int put_shading(std::span<const double> values) { return put_reals(values); }
  int put_shading(std::initializer_list<double> values) { return put_reals(std::span(values)); }
  int put_floats(std::span<const float> values) { return put_reals(values); }
  int put_rgb(const Rgb& c) { return put_shading({c.r, c.g, c.b}); }
  int put_index(std::span<const std::int32_t> values) {
    const int at = index_end();
    index.insert(index.end(), values.begin(), values.end());
    return at;
  }

 private:
  template <typename Value>
  int put_reals(std::span<const Value> values) {
    const int at = checked_offset(shading.size());
    for (const Value value : values) shading.push_back(static_cast<Real>(value));
    return at;
  }
};

}  // namespace strahl
