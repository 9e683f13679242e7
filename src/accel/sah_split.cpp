// SPDX-License-Identifier: MIT
// Binned SAH: I. Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", IEEE Symposium on Interactive
// Ray Tracing, 2007. Primitives are counted in the blocks that leaves are tested in, so that leaves fill.
#include "accel/sah_split.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "on_threads.h"

namespace strahl::accel {
namespace {

constexpr std::size_t most_bins = 32;

struct Bin {
  Box3 box;
  std::uint32_t count;
};

/// Of an axis as many as there is a use for: the small ranges are many, and what is left out takes longer than they do.
struct Bins {
  std::array<std::array<Bin, most_bins>, 3> axis;

  explicit Bins(std::size_t bins) {
    for (auto& of_axis : axis) std::fill_n(of_axis.begin(), bins, Bin{Box3::empty(), 0});
  }
  void include(const Bins& other, std::size_t bins) {
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < bins; ++b) {
        axis[a][b].box.include(other.axis[a][b].box);
        axis[a][b].count += other.axis[a][b].count;
      }
  }
};

/// Twice the centre of a primitive's box.
Float4 center2(const Primitive& primitive) { return primitive.box.lo + primitive.box.hi; }

struct Extent {
  Box3 box = Box3::empty(), centers = Box3::empty();
};

/// From twice a centre to its bin, per axis; the fourth means nothing.
struct BinScale {
  Float4 origin, scale;
  std::size_t bins;

  BinScale(const Box3& centers, std::size_t count)
      : origin(centers.lo), scale{}, bins(std::min(most_bins, 4 + count / 20)) {
    const Float4 size = centers.hi - centers.lo;
    // A little less than the number of bins, so that the last centre falls into the last bin.
    for (int a = 0; a < 3; ++a) {
      const float most = std::numeric_limits<float>::max(), apart = 0.9999F * static_cast<float>(bins) / size[a];
      // Centres may be so far apart, or so near, that neither is a number.
      scale[a] = size[a] > 0 && size[a] < most && apart < most ? apart : 0.0F;
    }
    // The fourth number of a centre is next to 0, and processors are slow at multiplying denormal ones.
    origin[3] = 1;
  }
  [[nodiscard]] Int4 bin(const Primitive& primitive) const {
    // Held within the bins whatever the numbers are: infinite boxes have no centre.
    const float last = static_cast<float>(bins - 1);
    const Float4 at = max4((center2(primitive) - origin) * scale, Float4{});
    return __builtin_convertvector(min4(at, Float4{last, last, last, last}), Int4);
  }
};

bool is_worth_threads(std::size_t size, unsigned threads) {
  // Below so many primitives a second thread costs more than it brings.
  return threads >= 2 && size >= std::size_t{1} << 15;
}

/// f(part, first, last) over as many parts as there are threads.
template <typename F>
void in_parts(std::size_t size, unsigned threads, const F& f) {
  if (!is_worth_threads(size, threads)) return f(std::size_t{0}, std::size_t{0}, size);
  on_threads(threads, threads, [&](std::size_t i) { f(i, size * i / threads, size * (i + 1) / threads); });
}

Extent extent_of(std::span<const Primitive> primitives, unsigned threads) {
  std::vector<Extent> parts(std::max(threads, 1U));
  in_parts(primitives.size(), threads, [&](std::size_t part, std::size_t first, std::size_t last) {
    Extent extent;
    for (const Primitive& p : primitives.subspan(first, last - first)) {
      extent.box.include(p.box);
      extent.centers.include(center2(p));
    }
    parts[part] = extent;
  });
  for (const Extent& part : parts) {
    parts[0].box.include(part.box);
    parts[0].centers.include(part.centers);
  }
  return parts[0];
}

void fill(std::span<const Primitive> primitives, const BinScale& scale, Bins& bins) {
  for (const Primitive& p : primitives) {
    const Int4 at = scale.bin(p);
    for (int a = 0; a < 3; ++a) {
      Bin& bin = bins.axis[static_cast<std::size_t>(a)][static_cast<std::size_t>(at[a])];
      bin.box.include(p.box);
      ++bin.count;
    }
  }
}

Bins filled(std::span<const Primitive> primitives, const BinScale& scale, unsigned threads) {
  Bins bins(scale.bins);
  if (!is_worth_threads(primitives.size(), threads)) {
    fill(primitives, scale, bins);
    return bins;
  }
  std::vector<Bins> parts(threads, bins);
  in_parts(primitives.size(), threads, [&](std::size_t part, std::size_t first, std::size_t last) {
    fill(primitives.subspan(first, last - first), scale, parts[part]);
  });
  for (const Bins& part : parts) bins.include(part, scale.bins);
  return bins;
}

struct Plane {
  int axis = -1;        ///< -1: none that leaves something on both sides.
  std::size_t bin = 0;  ///< First on the right.
  float cost = std::numeric_limits<float>::max();
};

float blocks(std::uint32_t count, int block) {
  const auto of_one = static_cast<std::uint32_t>(block);
  const std::uint32_t whole = (count + of_one - 1) / of_one;
  return static_cast<float>(whole);
}

Plane best_plane(const Bins& bins, const BinScale& scale, int block) {
  Plane best;
  for (int a = 0; a < 3; ++a) {
    if (scale.scale[a] == 0) continue;
    const auto& axis = bins.axis[static_cast<std::size_t>(a)];
    std::array<float, most_bins> right_cost;
    std::array<std::uint32_t, most_bins> right_count;
    Bin right{Box3::empty(), 0};
    for (std::size_t b = scale.bins; b-- > 1;) {
      right.box.include(axis[b].box);
      right.count += axis[b].count;
      right_cost[b] = right.box.half_area() * blocks(right.count, block);
      right_count[b] = right.count;
    }
    Bin left{Box3::empty(), 0};
    for (std::size_t b = 1; b < scale.bins; ++b) {
      left.box.include(axis[b - 1].box);
      left.count += axis[b - 1].count;
      if (left.count == 0 || right_count[b] == 0) continue;
      const float cost = left.box.half_area() * blocks(left.count, block) + right_cost[b];
      if (cost < best.cost) best = {a, b, cost};
    }
  }
  return best;
}

/// By number of primitives, along the longest axis of their centres.
std::uint32_t halve(std::span<Primitive> primitives, const Box3& centers) {
  const Float4 size = centers.hi - centers.lo;
  const int axis = size[0] >= size[1] && size[0] >= size[2] ? 0 : (size[1] >= size[2] ? 1 : 2);
  const std::size_t middle = primitives.size() / 2;
  std::nth_element(primitives.begin(), primitives.begin() + static_cast<std::ptrdiff_t>(middle), primitives.end(),
                   [axis](const Primitive& a, const Primitive& b) {
                     const float of_a = center2(a)[axis], of_b = center2(b)[axis];
                     return of_a < of_b || (of_a == of_b && a.number() < b.number());
                   });
  return static_cast<std::uint32_t>(middle);
}

/// Those of the first one's kind go left.
std::uint32_t by_kind(std::span<Primitive> primitives) {
  const std::uint32_t kind = primitives.front().kind();
  const auto middle = std::stable_partition(primitives.begin(), primitives.end(),
                                            [kind](const Primitive& p) { return p.kind() == kind; });
  return static_cast<std::uint32_t>(middle - primitives.begin());
}

}  // namespace

Split split_range(std::span<Primitive> primitives, const BuildOptions& options, int depth, unsigned threads) {
  const Extent extent = extent_of(primitives, threads);
  Split split{0, extent.box.half_area()};
  const auto count = static_cast<std::uint32_t>(primitives.size());
  const bool fits = count <= static_cast<std::uint32_t>(options.max_leaf);
  Plane plane;
  std::optional<BinScale> scale;
  if (count > 1 && depth < options.balanced_below && !(fits && options.block >= options.max_leaf)) {
    scale.emplace(extent.centers, count);
    plane = best_plane(filled(primitives, *scale, threads), *scale, options.block);
  }
  const bool pays = plane.axis >= 0 && split.half_area + plane.cost < split.half_area * blocks(count, options.block);
  if (fits && !pays) {
    split.at = by_kind(primitives);
    const bool is_single =
        options.single_kind >= 0 && primitives.front().kind() == static_cast<std::uint32_t>(options.single_kind);
    if (split.at == count) split.at = count > 1 && is_single ? halve(primitives, extent.centers) : 0;
    return split;
  }
  if (plane.axis < 0) {
    split.at = halve(primitives, extent.centers);
    return split;
  }
  const auto middle = std::partition(primitives.begin(), primitives.end(), [&](const Primitive& p) {
    return static_cast<std::size_t>(scale->bin(p)[plane.axis]) < plane.bin;
  });
  split.at = static_cast<std::uint32_t>(middle - primitives.begin());
  return split;
}

}  // namespace strahl::accel
