// SPDX-License-Identifier: MIT
#include <algorithm>
#include <vector>

#include "kinds/entries.h"
#include "packing/cl_layout.h"
#include "packing/pack_shapes.h"
#include "packing/packed_ranges.h"

namespace strahl {
namespace {

template <typename Real>
class Trees {
 public:
  Trees(PackedRanges<Real>& ranges, const PackedFacts& facts)
      : ranges_(ranges), facts_(facts), lanes_(facts.options.lanes) {
    width_ = lanes_ > 1 ? facts.options.lanes : facts.options.tree_width == 0 ? 4 : facts.options.tree_width;
    for (const std::string& kind : list_entries("shapes"))
      if (facts.features.has("shapes", kind)) kinds_.push_back(kind);
    has_instances_ = facts.features.flag("INSTANCES");
  }

  void run() {
    for (std::size_t kind = 0; kind < kinds_.size(); ++kind) blocks_of(kind);
    if (ranges_.fault().empty()) ids();
    if (has_instances_ && ranges_.fault().empty()) instances();
    if (ranges_.fault().empty()) nodes();
    if (!ranges_.fault().empty()) return;
    const int root = ranges_.at(layout::HEADER_ROOT);
    ranges_.geometry(ranges_.at(layout::HEADER_BOUNDS), 6, "the bounds");
    const Subtree tree = reference(root, -1);
    int within = 0;
    for (std::int64_t i = 0; has_instances_ && i < instances_count() && ranges_.fault().empty(); ++i)
      within = std::max(within, group(ranges_.at(ranges_.at(row(kinds_.size()) + layout::SHAPE_IDS) + i)));
    const int need = std::max(tree.need, lists() + 1) + (instances_count() > 0 ? 1 + within : 0);
    ranges_.require(need <= stack_entries(width_), "the tree is too deep for its stack");
    if (facts_.features.flag("MEDIA") && ranges_.fault().empty()) boundaries();
  }

 private:
  struct Subtree {
    int need = 0;  ///< Entries of the stack.
    bool has_instances = false;
  };

  [[nodiscard]] static std::int64_t row(std::size_t kind) {
    return layout::HEADER_INTS + static_cast<std::int64_t>(kind) * layout::SHAPE_INTS;
  }
  [[nodiscard]] std::int64_t entry(std::size_t kind, int field) const { return ranges_.at(row(kind) + field); }
  [[nodiscard]] std::int64_t instances_count() const {
    return has_instances_ ? entry(kinds_.size(), layout::SHAPE_BLOCKS) : 0;
  }
  [[nodiscard]] int lists() const { return static_cast<int>(kinds_.size()); }

  void blocks_of(std::size_t kind) {
    const std::int64_t blocks = entry(kind, layout::SHAPE_BLOCKS), slots = blocks * lanes_;
    const auto which = static_cast<std::int64_t>(kind);
    if (!ranges_.require(blocks >= 0, "the blocks of kind", which)) return;
    ranges_.geometry(entry(kind, layout::SHAPE_GEOMETRY), slots * planes_of(kinds_[kind]), "the blocks of kind", which);
    ranges_.index(entry(kind, layout::SHAPE_IDS), 2 * slots, "the ids of kind", which);
    ranges_.within(entry(kind, layout::SHAPE_LISTED), 0, blocks + 1, "the list of kind", which);
  }

  /// Every primitive has a slot of its own; those left over have the id -1, and are never hit.
  void ids() {
    std::int64_t wanted = 0, found = 0;
    for_each_shape(facts_.scene, [&](const Shape& shape) {
      if (facts_.features.has("shapes", shape_kind(shape))) wanted += primitive_count(shape);
    });
    const auto parts = static_cast<std::int64_t>(facts_.parts.size());
    for (std::size_t kind = 0; kind < kinds_.size(); ++kind) {
      const std::int64_t slots = entry(kind, layout::SHAPE_BLOCKS) * lanes_, first = entry(kind, layout::SHAPE_IDS);
      for (std::int64_t i = 0; i < slots; ++i) {
        const std::int64_t id = ranges_.at(first + i), part = ranges_.at(first + slots + i);
        if (id == -1) {
          ranges_.require(part == 0, "the part of no primitive");
          continue;
        }
        ++found;
        if (!ranges_.within(part, 0, parts, "the part of primitive", id)) return;
        const PackedPart& owner = facts_.parts[static_cast<std::size_t>(part)];
        if (!ranges_.within(id, owner.first_id, owner.first_id + owner.primitives, "the primitive of part", part))
          return;
      }
    }
    ranges_.require(found == wanted, "the number of primitives");
  }

  /// Those of media that stand apart.
  void boundaries() {
    const std::size_t rows = kinds_.size() + (has_instances_ ? 1 : 0);
    const std::int64_t at = ranges_.at(row(rows) + layout::MEDIA_BOUNDARIES);
    if (at != 0)
      ranges_.require(group(at) <= stack_entries(width_), "the tree of boundaries is too deep for its stack");
  }

  void instances() {
    const std::size_t kind = kinds_.size();
    const std::int64_t count = instances_count();
    if (!ranges_.require(count >= 0, "the number of instances")) return;
    ranges_.geometry(entry(kind, layout::SHAPE_GEOMETRY), count * layout::INSTANCE_REALS, "the instances");
    ranges_.index(entry(kind, layout::SHAPE_IDS), count, "the instances");
    ranges_.within(entry(kind, layout::SHAPE_LISTED), 0, count + 1, "the list of instances");
  }

  /// Parents stand before their children, so no way leads back.
  void nodes() {
    const auto count = static_cast<std::int64_t>(ranges_.packed().tree.nodes);
    const std::int64_t children = ranges_.at(layout::HEADER_CHILDREN);
    ranges_.geometry(ranges_.at(layout::HEADER_NODES), count * layout::NODE_PLANES * width_, "the nodes");
    if (!ranges_.index(children, count * width_, "the children of nodes")) return;
    subtrees_.resize(static_cast<std::size_t>(count));
    for (std::int64_t node = count - 1; node >= 0 && ranges_.fault().empty(); --node) {
      Subtree& tree = subtrees_[static_cast<std::size_t>(node)];
      for (std::int64_t i = 0; i < width_; ++i) {
        const Subtree child = reference(ranges_.at(children + node * width_ + i), node);
        tree.need = std::max(tree.need, child.need);
        tree.has_instances = tree.has_instances || child.has_instances;
      }
      tree.need += width_ - 1;
    }
  }

  /// Of the node `parent`, or of a root.
  Subtree reference(std::int32_t to, std::int64_t parent) {
    if (to == no_reference && parent < 0) return {};
    if (to >= 0) {
      if (!ranges_.within(to, parent + 1, static_cast<std::int64_t>(subtrees_.size()), "a child of node", parent))
        return {};
      return subtrees_[static_cast<std::size_t>(to)];
    }
    const auto leaf = ~static_cast<std::uint32_t>(to);
    const std::size_t kind = leaf & (layout::REFERENCE_MOST_KINDS - 1U);
    const std::int64_t block = leaf >> layout::REFERENCE_BLOCK;
    const std::int64_t count = leaf >> layout::REFERENCE_COUNT & layout::REFERENCE_MOST_BLOCKS;
    const bool is_instance = has_instances_ && kind == kinds_.size();
    if (!ranges_.require(kind < kinds_.size() || is_instance, "the kind of a leaf of node", parent)) return {};
    // A leaf of no blocks is all that the kind lists.
    const std::int64_t end = block + (count > 0 ? count : is_instance ? 0 : entry(kind, layout::SHAPE_LISTED));
    ranges_.require(end <= entry(kind, layout::SHAPE_BLOCKS), "the blocks of a leaf of node", parent);
    return {0, is_instance};
  }

  /// The entries of the stack that a group takes.
  int group(std::int64_t at) {
    const auto kinds = static_cast<std::int64_t>(kinds_.size());
    if (!ranges_.index(at, layout::GROUP_LISTED + 2 * kinds, "a group")) return 0;
    ranges_.geometry(ranges_.at(at + layout::GROUP_BOUNDS), 6, "the bounds of a group");
    for (std::int64_t kind = 0; kind < kinds; ++kind) {
      const std::int64_t first = ranges_.at(at + layout::GROUP_LISTED + 2 * kind);
      const std::int64_t count = ranges_.at(at + layout::GROUP_LISTED + 2 * kind + 1);
      ranges_.require(
          first >= 0 && count >= 0 && first + count <= entry(static_cast<std::size_t>(kind), layout::SHAPE_BLOCKS),
          "what a group lists");
    }
    const Subtree tree = reference(ranges_.at(at + layout::GROUP_ROOT), -1);
    ranges_.require(!tree.has_instances, "a group has instances");
    return std::max(tree.need, lists() + 1);
  }

  static constexpr std::int32_t no_reference = NO_REFERENCE;

  PackedRanges<Real>& ranges_;
  const PackedFacts& facts_;
  std::int64_t lanes_;
  int width_ = 0;
  std::vector<std::string> kinds_;  ///< Active ones.
  bool has_instances_ = false;
  std::vector<Subtree> subtrees_;  ///< Of every node.
};

}  // namespace

template <typename Real>
void check_trees(PackedRanges<Real>& ranges, const PackedFacts& facts) {
  if (ranges.fault().empty()) Trees<Real>(ranges, facts).run();
}

template void check_trees(PackedRanges<float>&, const PackedFacts&);
template void check_trees(PackedRanges<double>&, const PackedFacts&);

}  // namespace strahl
