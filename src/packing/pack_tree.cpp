// SPDX-License-Identifier: MIT
#include "packing/pack_tree.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "accel/wide_tree.h"
#include "errors.h"
#include "kinds/entries.h"
#include "packing/cl_layout.h"
#include "packing/outline.h"
#include "packing/primitive_bounds.h"
#include "stopwatch.h"

namespace strahl {
namespace {

int lanes_of(int width) { return width >= 8 ? width : 1; }

/// Leaves of scalar trees hold a few primitives, tested one after the other.
int most_in_leaf(int width) { return width >= 8 ? width : 4; }

/// Up to so many bounded primitives a list is no slower than a tree (docs/performance.md).
std::size_t list_up_to(int width) { return width >= 8 ? 4 * static_cast<std::size_t>(width) : 4; }

bool is_tree(Acceleration acceleration, std::size_t bounded, int width) {
  if (acceleration == Acceleration::automatic) return bounded > list_up_to(width);
  return acceleration == Acceleration::tree && bounded > 0;
}

std::int32_t leaf_reference(std::size_t block, std::size_t count, std::size_t kind, int width) {
  static_assert(most_blocks == std::int64_t{1} << (31 - layout::REFERENCE_BLOCK));
  if (block >= static_cast<std::size_t>(most_blocks))
    throw Error(fmt::format(
        "the scene is too large for a tree of {} children a node: more than {} blocks of a kind; {}simplify the meshes",
        width, most_blocks,
        width < 8    ? "state --bvh-width 8, or "
        : width < 16 ? "state --bvh-width 16, or "
                     : ""));
  return ~static_cast<std::int32_t>(block << layout::REFERENCE_BLOCK | count << layout::REFERENCE_COUNT | kind);
}

/// Of a box that may be a rounding larger.
template <typename Real>
std::vector<Real> center_and_half(const Bounds<Real>& box) {
  std::vector<Real> values(6);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Real lo = box[2 * axis], hi = box[2 * axis + 1], center = lo / 2 + hi / 2;
    values[axis] = center;
    values[3 + axis] = std::nextafter(std::max(hi - center, center - lo), std::numeric_limits<Real>::infinity());
  }
  return values;
}

template <typename Real>
class TreePacking {
 public:
  TreePacking(std::vector<KindList<Real>> lists, const std::vector<Bounds<Real>>& instances, const TreeOptions& options)
      : lists_(std::move(lists)), instances_(instances), options_(options), width_(options.width) {
    for (const KindList<Real>& list : lists_) bounds_of_.push_back(bounds_function<Real>(list.kind));
    boxes_.resize(lists_.size());
    packed_.kinds.resize(lists_.size());
    packed_.root = NO_REFERENCE;
  }

  PackedTree<Real> run() {
    std::size_t bounded = instances_.size();
    Bounds<Real> reach = empty_bounds<Real>();
    for (std::size_t k = 0; k < lists_.size(); ++k) {
      if (bounds_of_[k] == nullptr) continue;
      bounded += lists_[k].ids.size();
      boxes_[k].reserve(lists_[k].ids.size());
      const Real* values = lists_[k].values.data();
      for (std::size_t i = 0; i < lists_[k].ids.size(); ++i, values += lists_[k].planes) {
        boxes_[k].push_back(bounds_of_[k](values));
        include(reach, boxes_[k].back());
      }
    }
    if (options_.outline > 0) outline_of_shapes();
    for (const Bounds<Real>& box : instances_) include(reach, box);
    if (bounded == 0) reach = {};
    packed_.reach = center_and_half(reach);
    if (is_tree(options_.acceleration, bounded, width_)) tree(reach, bounded);
    for (std::size_t k = 0; k < lists_.size(); ++k)
      if (bounds_of_[k] == nullptr || packed_.root == NO_REFERENCE) list(k);
    packed_.lists_instances = packed_.root == NO_REFERENCE && !instances_.empty();
    // At first all lists wait, and a list of instances of which one is entered.
    packed_.stack_need =
        std::max(packed_.stack_need, static_cast<int>(lists_.size()) + 1) + (instances_.empty() ? 0 : 1);
    return std::move(packed_);
  }

 private:
  [[nodiscard]] Bounds<Real> bounds(std::size_t kind, std::size_t i) const {
    if (kind == lists_.size()) return instances_[i];
    return boxes_[kind][i];
  }
  [[nodiscard]] std::size_t lanes() const { return static_cast<std::size_t>(lanes_of(width_)); }

  void outline_of_shapes() {
    for (const auto& boxes : boxes_) packed_.outline.insert(packed_.outline.end(), boxes.begin(), boxes.end());
    packed_.outline = outline(std::move(packed_.outline), options_.outline);
  }

  /// Primitives [0, count) of a kind, given by number(i), into new blocks.
  template <typename Number>
  void append(std::size_t k, std::size_t count, const Number& number) {
    const KindList<Real>& list = lists_[k];
    PackedKind<Real>& kind = packed_.kinds[k];
    const auto planes = static_cast<std::size_t>(list.planes);
    const std::size_t blocks = (count + lanes() - 1) / lanes(), first = kind.ids.size() / lanes();
    kind.blocks.resize((first + blocks) * planes * lanes(), Real(0));
    kind.ids.resize((first + blocks) * lanes(), -1);
    kind.parts.resize((first + blocks) * lanes(), 0);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t from = number(i), slot = first * lanes() + i;
      Real* to = kind.blocks.data() + slot / lanes() * planes * lanes() + slot % lanes();
      for (std::size_t plane = 0; plane < planes; ++plane) to[plane * lanes()] = list.values[from * planes + plane];
      kind.ids[slot] = list.ids[from];
      kind.parts[slot] = list.parts[from];
    }
  }

  void list(std::size_t k) {
    append(k, lists_[k].ids.size(), [](std::size_t i) { return i; });
    packed_.kinds[k].listed = static_cast<int>(packed_.kinds[k].ids.size() / lanes());
  }

  /// Around the middle of everything, so that single precision has digits left for the differences.
  [[nodiscard]] std::vector<accel::Primitive> primitives(const Bounds<Real>& reach, std::size_t bounded) const {
    std::vector<accel::Primitive> primitives;
    primitives.reserve(bounded);
    std::array<Real, 3> middle;
    for (std::size_t axis = 0; axis < 3; ++axis) middle[axis] = reach[2 * axis] / 2 + reach[2 * axis + 1] / 2;
    for (std::size_t k = 0; k <= lists_.size(); ++k) {
      const bool is_instances = k == lists_.size();
      if (!is_instances && bounds_of_[k] == nullptr) continue;
      for (std::size_t i = 0; i < (is_instances ? instances_.size() : lists_[k].ids.size()); ++i) {
        const Bounds<Real> b = bounds(k, i);
        const auto at = [&](std::size_t plane) { return static_cast<float>(b[plane] - middle[plane / 2]); };
        primitives.emplace_back(accel::Float4{at(0), at(2), at(4), 0}, accel::Float4{at(1), at(3), at(5), 0},
                                static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(k));
      }
    }
    return primitives;
  }

  void tree(const Bounds<Real>& reach, std::size_t bounded) {
    const Stopwatch start;
    accel::BuildOptions options;
    // An instance costs as much as many primitives: where they are most of the scene, one is a leaf.
    const bool is_of_instances = 2 * instances_.size() > bounded;
    options.block = is_of_instances ? 1 : lanes_of(width_);
    options.max_leaf = is_of_instances ? 1 : most_in_leaf(width_);
    options.single_kind = static_cast<int>(lists_.size());
    accel::BinaryTree binary;
    accel::WideTree wide;
    // Ever less deep until the stack suffices: halves by number are never deeper than a few levels a width.
    for (const int balanced_below : {options.balanced_below, 24, 12, 0}) {
      options.balanced_below = balanced_below;
      binary = accel::build_binary_tree(primitives(reach, bounded), options);
      wide = accel::collapse(binary, width_);
      if (wide.stack_need >= options_.stack) wide = accel::collapse(binary, width_, accel::Aim::least_depth);
      if (wide.stack_need < options_.stack) break;
    }
    if (wide.stack_need >= options_.stack) throw std::logic_error("a balanced tree is too deep for its stack");
    packed_.stack_need = wide.stack_need;
    packed_.stats.sah_cost = binary.sah_cost(options.block);
    packed_.stats.seconds = start.seconds();
    packed_.stats.primitives = bounded;
    packed_.stats.nodes = wide.nodes();
    packed_.stats.leaves = wide.leaves.size();
    leaves(binary, wide);
    nodes(wide);
    packed_.stats.bytes = packed_.nodes.size() * sizeof(Real) + packed_.children.size() * sizeof(std::int32_t);
    for (const PackedKind<Real>& kind : packed_.kinds)
      packed_.stats.bytes += kind.blocks.size() * sizeof(Real) + 2 * kind.ids.size() * sizeof(std::int32_t);
  }

  void leaves(const accel::BinaryTree& binary, const accel::WideTree& wide) {
    references_.reserve(wide.leaves.size());
    leaf_bounds_.reserve(wide.leaves.size());
    for (const accel::WideLeaf& leaf : wide.leaves) {
      if (leaf.kind == lists_.size()) {
        const std::size_t instance = binary.primitives[leaf.first].number();
        leaf_bounds_.push_back(instances_[instance]);
        references_.push_back(leaf_reference(instance, 1, leaf.kind, width_));
        continue;
      }
      const std::size_t block = packed_.kinds[leaf.kind].ids.size() / lanes();
      const std::size_t count = (leaf.count + lanes() - 1) / lanes();
      append(leaf.kind, leaf.count, [&](std::size_t i) { return binary.primitives[leaf.first + i].number(); });
      Bounds<Real> box = empty_bounds<Real>();
      for (std::uint32_t i = 0; i < leaf.count; ++i)
        include(box, bounds(leaf.kind, binary.primitives[leaf.first + i].number()));
      leaf_bounds_.push_back(box);
      references_.push_back(leaf_reference(block, count, leaf.kind, width_));
    }
  }

  /// Children before parents, so from the last node to the first.
  void nodes(const accel::WideTree& wide) {
    const auto width = static_cast<std::size_t>(width_);
    packed_.nodes.resize(wide.nodes() * layout::NODE_PLANES * width);
    // Where boxes are of no help, an empty child may be entered: a leaf of a kind that lists nothing.
    packed_.children.resize(wide.children.size(), ~static_cast<std::int32_t>(wide.leaves.front().kind));
    std::vector<Bounds<Real>> boxes(wide.nodes(), empty_bounds<Real>());
    for (std::size_t node = wide.nodes(); node-- > 0;)
      for (std::size_t i = 0; i < width; ++i) {
        const std::int32_t child = wide.children[node * width + i];
        Bounds<Real> box = empty_bounds<Real>();
        if (child != accel::WideTree::none) {
          box = child >= 0 ? boxes[static_cast<std::size_t>(child)] : leaf_bounds_[static_cast<std::size_t>(~child)];
          packed_.children[node * width + i] = child >= 0 ? child : references_[static_cast<std::size_t>(~child)];
        }
        include(boxes[node], box);
        for (std::size_t plane = 0; plane < layout::NODE_PLANES; ++plane)
          packed_.nodes[(node * layout::NODE_PLANES + plane) * width + i] = box[plane];
      }
    packed_.root = wide.root >= 0 ? wide.root : references_[static_cast<std::size_t>(~wide.root)];
  }

  std::vector<KindList<Real>> lists_;
  const std::vector<Bounds<Real>>& instances_;
  TreeOptions options_;
  int width_;
  std::vector<BoundsFunction<Real>> bounds_of_;
  std::vector<std::vector<Bounds<Real>>> boxes_;  ///< Of every primitive that is bounded.
  std::vector<std::int32_t> references_;          ///< Of every leaf.
  std::vector<Bounds<Real>> leaf_bounds_;
  PackedTree<Real> packed_;
};

/// Of a group's tree, after `nodes` nodes and blocks[kind] blocks of every kind.
std::int32_t moved(std::int32_t reference, std::size_t nodes, const std::vector<std::size_t>& blocks, int width) {
  if (reference == NO_REFERENCE) return reference;
  if (reference >= 0) return reference + static_cast<std::int32_t>(nodes);
  const auto leaf = ~static_cast<std::uint32_t>(reference);
  const std::size_t kind = leaf & (layout::REFERENCE_MOST_KINDS - 1);
  const std::size_t count = leaf >> layout::REFERENCE_COUNT & layout::REFERENCE_MOST_BLOCKS;
  if (count == 0) return reference;
  return leaf_reference((leaf >> layout::REFERENCE_BLOCK) + blocks[kind], count, kind, width);
}

template <typename T>
void append(std::vector<T>& to, const std::vector<T>& values) {
  to.insert(to.end(), values.begin(), values.end());
}

}  // namespace

bool calls_for_tree(const Scene& scene, const Features& features, int width, Acceleration acceleration) {
  if (features.flag("INSTANCES")) return true;
  if (acceleration == Acceleration::list) return false;
  std::size_t bounded = 0;
  for (const Shape& shape : scene.shapes) {
    const std::string kind = shape_kind(shape);
    if (!features.has("shapes", kind) || bounds_function<float>(kind) == nullptr) continue;
    bounded += static_cast<std::size_t>(primitive_count(shape));
    if (is_tree(acceleration, bounded, width)) return true;
  }
  return false;
}

int stack_entries(int width) {
  return width == 2 ? layout::STACK_2 : width == 4 ? layout::STACK_4 : width == 8 ? layout::STACK_8 : layout::STACK_16;
}

template <typename Real>
Bounds<Real> PackedTree<Real>::box() const {
  const auto side = [&](std::size_t axis, double sign) { return double(reach[axis]) + sign * double(reach[3 + axis]); };
  return rounded_outwards<Real>({side(0, -1), side(1, -1), side(2, -1)}, {side(0, 1), side(1, 1), side(2, 1)});
}

template <typename Real>
PackedTree<Real> pack_tree(std::vector<KindList<Real>> lists, const std::vector<Bounds<Real>>& instances,
                           const TreeOptions& options) {
  return TreePacking<Real>(std::move(lists), instances, options).run();
}

template <typename Real>
AppendedTree append_tree(PackedTree<Real>& all, const PackedTree<Real>& group, int width) {
  AppendedTree appended;
  std::vector<std::size_t> blocks;
  for (std::size_t k = 0; k < all.kinds.size(); ++k) {
    const auto lanes = static_cast<std::size_t>(lanes_of(width));
    blocks.push_back(all.kinds[k].ids.size() / lanes);
    appended.listed.push_back({static_cast<std::int32_t>(blocks[k]), group.kinds[k].listed});
    append(all.kinds[k].blocks, group.kinds[k].blocks);
    append(all.kinds[k].ids, group.kinds[k].ids);
    append(all.kinds[k].parts, group.kinds[k].parts);
  }
  const std::size_t nodes = all.children.size() / static_cast<std::size_t>(width);
  appended.root = moved(group.root, nodes, blocks, width);
  append(all.nodes, group.nodes);
  for (const std::int32_t child : group.children) all.children.push_back(moved(child, nodes, blocks, width));
  all.stats.seconds += group.stats.seconds;
  all.stats.primitives += group.stats.primitives;
  all.stats.nodes += group.stats.nodes;
  all.stats.leaves += group.stats.leaves;
  all.stats.bytes += group.stats.bytes;
  return appended;
}

template struct PackedTree<float>;
template struct PackedTree<double>;
template PackedTree<float> pack_tree(std::vector<KindList<float>>, const std::vector<Bounds<float>>&,
                                     const TreeOptions&);
template PackedTree<double> pack_tree(std::vector<KindList<double>>, const std::vector<Bounds<double>>&,
                                      const TreeOptions&);
template AppendedTree append_tree(PackedTree<float>&, const PackedTree<float>&, int);
template AppendedTree append_tree(PackedTree<double>&, const PackedTree<double>&, int);

}  // namespace strahl
