// SPDX-License-Identifier: MIT
#include "packing/outline.h"

#include <cmath>
#include <map>

namespace strahl {

// All instances together go through 4 million boxes, 40 ns each; where they are more than a million, through 8 each.
std::size_t outline_size(std::size_t instances) { return (std::size_t{1} << 22) / std::max<std::size_t>(1, instances); }

template <typename Real>
std::vector<Bounds<Real>> outline(std::vector<Bounds<Real>> boxes, std::size_t most) {
  if (boxes.size() <= most) return boxes;
  // A surface that goes around meets some 3 cells^2 of them.
  const std::size_t cells = std::clamp(static_cast<std::size_t>(std::sqrt(most / 3)), std::size_t{2}, std::size_t{64});
  Bounds<Real> all = empty_bounds<Real>();
  for (const Bounds<Real>& box : boxes) include(all, box);
  const auto cell = [&](const Bounds<Real>& box, std::size_t axis) -> std::size_t {
    const Real lo = all[2 * axis], size = all[2 * axis + 1] - lo;
    if (!(size > 0) || !std::isfinite(size)) return 0;
    const Real from_lo = box[2 * axis] / 2 + box[2 * axis + 1] / 2 - lo;
    return std::min(static_cast<std::size_t>(from_lo / size * static_cast<Real>(cells)), cells - 1);
  };
  std::map<std::array<std::size_t, 3>, Bounds<Real>> of_cells;
  for (const Bounds<Real>& box : boxes) {
    const std::array at{cell(box, 0), cell(box, 1), cell(box, 2)};
    include(of_cells.try_emplace(at, empty_bounds<Real>()).first->second, box);
  }
  boxes.clear();
  for (const auto& [at, box] : of_cells) boxes.push_back(box);
  return boxes;
}

template std::vector<Bounds<float>> outline(std::vector<Bounds<float>>, std::size_t);
template std::vector<Bounds<double>> outline(std::vector<Bounds<double>>, std::size_t);

}  // namespace strahl
