// SPDX-License-Identifier: MIT
#include "packing/majorants.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "packing/cell_axis.h"
#include "scene/model/scene.h"

namespace strahl {
namespace {

constexpr double most_cells_an_axis = 128;  ///< As many as a grid of 1024 texels has.

double component(const Vec3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

float rounded_up(double value) {
  const auto rounded = static_cast<float>(std::min(value, static_cast<double>(std::numeric_limits<float>::max())));
  return static_cast<double>(rounded) < value ? std::nextafter(rounded, std::numeric_limits<float>::max()) : rounded;
}

/// Values over a box, x first.
struct Layers {
  std::array<int, 3> size;
  std::vector<float> values;
};

/// Replaces the layers of an axis by the largest over each of `groups` of them; value_of(n): the n-th value of the box.
template <class Value>
void reduce(Layers& box, std::size_t along, const std::vector<std::vector<int>>& groups, Value value_of) {
  const std::array<int, 3> from = box.size;
  box.size[along] = static_cast<int>(groups.size());
  const auto at = [&](std::array<int, 3> p) {
    return (static_cast<std::size_t>(p[2]) * static_cast<std::size_t>(from[1]) + static_cast<std::size_t>(p[1])) *
               static_cast<std::size_t>(from[0]) +
           static_cast<std::size_t>(p[0]);
  };
  box.values.clear();
  for (int z = 0; z < box.size[2]; ++z)
    for (int y = 0; y < box.size[1]; ++y)
      for (int x = 0; x < box.size[0]; ++x) {
        std::array<int, 3> p{x, y, z};
        float most = 0;
        for (const int layer : groups[static_cast<std::size_t>(p[along])]) {
          std::array<int, 3> q = p;
          q[along] = layer;
          most = std::max(most, value_of(at(q)));
        }
        box.values.push_back(most);
      }
}

}  // namespace

std::vector<double> box_frame(const Transform& world_from_cube, const UploadFrame& frame, const Vec3& size,
                              const Vec3& middle) {
  const Transform cube_from_world = world_from_cube.inverse();
  const Vec3 origin = frame.point(world_from_cube.point(middle));
  std::vector<double> reals{origin.x, origin.y, origin.z};
  for (int axis = 0; axis < 3; ++axis)
    for (std::size_t column = 0; column < 3; ++column)
      reals.push_back(component(size, axis) * cube_from_world.m[static_cast<std::size_t>(axis)][column] / frame.scale);
  return reals;
}

Majorants majorants_of(const Volume& sigma_t, const UploadFrame& frame) {
  const Transform& cube = sigma_t.world_from_cube;
  const VolumeGrid& grid = *sigma_t.grid;
  const Box world = bounds({{0, 0, 0}, {1, 1, 1}}, cube);
  const Box local = bounds(world, cube.inverse());
  const std::array<int, 3> size{grid.texels.width, grid.height, grid.depth};
  std::array<double, 3> cells{}, middle{};
  std::array<std::vector<std::vector<int>>, 3> texels;
  Majorants result;
  for (std::size_t i = 0; i < 3; ++i) {
    const int number = static_cast<int>(i);
    const CellAxis axis =
        cells_over({component(local.min, number), component(local.max, number)}, size[i], most_cells_an_axis);
    texels[i] = texels_of_cells(axis, size[i], sigma_t.wrap);
    cells[i] = size[i] / axis.cell;
    middle[i] = (axis.first + 0.5 * axis.count) * axis.cell / size[i];
    result.size[i] = axis.count;
    const Vec3 edge = cube.column(number);
    // Of few texels the cell is longer than all there is of the medium.
    const double share = std::min(1 / cells[i], component(local.max, number) - component(local.min, number));
    result.cell = std::max(result.cell, frame.scale * std::sqrt(dot(edge, edge)) * share);
  }
  result.reals = box_frame(cube, frame, {cells[0], cells[1], cells[2]}, {middle[0], middle[1], middle[2]});
  for (const Vec3& end : {world.min, world.max}) {
    const Vec3 corner = frame.point(end);
    result.reals.insert(result.reals.end(), {corner.x, corner.y, corner.z});
  }
  const TexelDecoder decoded(grid.texels, {TexelCurve::Kind::linear, 1});
  const Rgb& value = sigma_t.value;
  // One axis after the other, those first that leave the fewest values; the first one decodes.
  std::array<std::size_t, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return result.size[a] * std::int64_t{size[b]} < result.size[b] * std::int64_t{size[a]};
  });
  Layers box{size, {}};
  reduce(box, order[0], texels[order[0]], [&](std::size_t n) {
    const auto [r, g, b] = decoded(n);
    return rounded_up(std::max({value.r * r, value.g * g, value.b * b}) / frame.scale);
  });
  for (const std::size_t axis : {order[1], order[2]}) {
    const std::vector<float> values = std::move(box.values);
    reduce(box, axis, texels[axis], [&](std::size_t n) { return values[n]; });
  }
  result.most = std::move(box.values);
  return result;
}

}  // namespace strahl
