// SPDX-License-Identifier: MIT
#include "packing/light_tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <optional>

#include "packing/cl_layout.h"
#include "packing/light_cluster.h"

namespace strahl {
namespace {

constexpr std::size_t bins = 12;

double along(const Vec3& v, std::size_t axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

class Builder {
 public:
  explicit Builder(std::span<const LightReach> lights)
      : order_(lights.size()), least_radius_(least_light_radius(lights)) {
    for (const LightReach& light : lights) {
      clusters_.push_back(LightCluster::of(light));
      const std::optional<Box>& box = clusters_.back().box;
      middles_.push_back(box ? 0.5 * (box->min + box->max) : Vec3{});
    }
    std::iota(order_.begin(), order_.end(), 0);
    tree_.ways.resize(lights.size());
  }

  LightTree run() {
    node(order_, 0, 0);
    return std::move(tree_);
  }

 private:
  using Lights = std::span<std::int32_t>;

  const LightCluster& cluster(std::int32_t light) const { return clusters_[static_cast<std::size_t>(light)]; }
  double place(std::int32_t light, std::size_t axis) const {
    return along(middles_[static_cast<std::size_t>(light)], axis);
  }

  LightCluster together(Lights lights) const {
    LightCluster all = cluster(lights.front());
    for (const std::int32_t light : lights.subspan(1)) all.include(cluster(light));
    return all;
  }

  /// Two lights at least. way: from the root to here, of `depth` steps. Returns the node's number.
  std::int32_t node(Lights lights, std::uint32_t way, int depth) {
    const auto number = static_cast<std::int32_t>(tree_.links.size() / 2);
    tree_.links.insert(tree_.links.end(), {0, 0});
    tree_.children.resize(tree_.children.size() + 2 * layout::LIGHT_CHILD_REALS);
    const std::size_t left = split(lights, depth);
    for (const bool is_right : {false, true}) {
      const Lights half = is_right ? lights.subspan(left) : lights.first(left);
      const std::size_t child = 2 * static_cast<std::size_t>(number) + (is_right ? 1 : 0);
      const std::vector<double> reals = together(half).reals(least_radius_);
      std::copy(reals.begin(), reals.end(),
                tree_.children.begin() + static_cast<std::ptrdiff_t>(child * layout::LIGHT_CHILD_REALS));
      const std::uint32_t way_on = way | (is_right ? 1U << depth : 0U);
      if (half.size() == 1) {
        tree_.ways[static_cast<std::size_t>(half.front())] = static_cast<std::int32_t>(way_on);
        tree_.links[child] = -1 - half.front();
      } else {
        const std::int32_t next = node(half, way_on, depth + 1);
        tree_.links[child] = next;
      }
    }
    return number;
  }

  /// Orders the lights so that the first ones, as many as it returns, are the left half.
  std::size_t split(Lights lights, int depth) {
    const auto far =
        std::stable_partition(lights.begin(), lights.end(), [&](std::int32_t light) { return cluster(light).is_far; });
    const auto far_count = static_cast<std::size_t>(far - lights.begin());
    if (far_count > 0 && far_count < lights.size()) return far_count;
    // Halves need no more steps than are left.
    const auto needed = static_cast<int>(std::bit_width(lights.size() - 1));
    if (far_count > 0 || depth + 2 + needed >= layout::LIGHT_TREE_DEPTH) return halves(lights, widest(lights));
    return cheapest(lights);
  }

  std::size_t widest(Lights lights) const {
    std::array<double, 3> widths{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [least, most] = range(lights, axis);
      widths[axis] = most - least;
    }
    return static_cast<std::size_t>(std::max_element(widths.begin(), widths.end()) - widths.begin());
  }

  std::pair<double, double> range(Lights lights, std::size_t axis) const {
    double least = place(lights.front(), axis), most = least;
    for (const std::int32_t light : lights) {
      least = std::min(least, place(light, axis));
      most = std::max(most, place(light, axis));
    }
    return {least, most};
  }

  std::size_t halves(Lights lights, std::size_t axis) {
    const std::size_t middle = lights.size() / 2;
    std::nth_element(
        lights.begin(), lights.begin() + static_cast<std::ptrdiff_t>(middle), lights.end(),
        [&](std::int32_t a, std::int32_t b) { return std::pair(place(a, axis), a) < std::pair(place(b, axis), b); });
    return middle;
  }

  /// By bins along each axis.
  std::size_t cheapest(Lights lights) {
    double least = INFINITY, threshold = 0;
    std::size_t best_axis = 3;
    const std::size_t wide = widest(lights);
    const auto [wide_least, wide_most] = range(lights, wide);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [first, last] = range(lights, axis);
      if (!(last > first)) continue;
      const double step = (last - first) / bins;
      std::array<std::optional<LightCluster>, bins> of_bin;
      for (const std::int32_t light : lights) {
        std::optional<LightCluster>& bin = of_bin[bin_of(place(light, axis), first, step)];
        if (bin)
          bin->include(cluster(light));
        else
          bin = cluster(light);
      }
      std::array<double, bins> after{};
      std::optional<LightCluster> sum;
      for (std::size_t i = bins - 1; i > 0; --i) after[i] = cost_with(sum, of_bin[i]);
      sum.reset();
      for (std::size_t i = 0; i + 1 < bins; ++i) {
        // Narrow axes are split at a higher price, so that boxes do not become flat.
        const double cost = (cost_with(sum, of_bin[i]) + after[i + 1]) * (wide_most - wide_least) / (last - first);
        if (!(cost < least)) continue;
        least = cost;
        best_axis = axis;
        threshold = first + step * static_cast<double>(i + 1);
      }
    }
    if (best_axis == 3) return halves(lights, wide);
    const auto middle = std::stable_partition(lights.begin(), lights.end(),
                                              [&](std::int32_t light) { return place(light, best_axis) < threshold; });
    const auto left = static_cast<std::size_t>(middle - lights.begin());
    return left == 0 || left == lights.size() ? halves(lights, wide) : left;
  }

  static std::size_t bin_of(double x, double first, double step) {
    return std::min(static_cast<std::size_t>((x - first) / step), bins - 1);
  }

  static double cost_with(std::optional<LightCluster>& sum, const std::optional<LightCluster>& more) {
    if (sum && more)
      sum->include(*more);
    else if (more)
      sum = more;
    return sum ? sum->cost() : 0;
  }

  std::vector<LightCluster> clusters_;
  std::vector<Vec3> middles_;
  std::vector<std::int32_t> order_;
  double least_radius_;
  LightTree tree_;
};

}  // namespace

LightTree light_tree(std::span<const LightReach> lights) { return Builder(lights).run(); }

}  // namespace strahl
