// SPDX-License-Identifier: MIT
// What check_packed asks of the buffers: whether so many numbers lie behind an offset, and the first fault.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <span>
#include <string>

#include "image/texels.h"
#include "packing/pack.h"
#include "packing/packed_scene.h"

namespace strahl {

/// Of a packed scene; what is asked of it after a fault changes nothing.
template <typename Real>
class PackedRanges {
 public:
  explicit PackedRanges(const PackedScene<Real>& packed) : packed_(packed) {}

  /// Empty: none.
  [[nodiscard]] const std::string& fault() const { return fault_; }

  /// Returns `is_sound`.
  bool require(bool is_sound, const char* what, std::int64_t which = -1) {
    if (!is_sound && fault_.empty()) fault_ = which < 0 ? std::string(what) : fmt::format("{} {}", what, which);
    return is_sound;
  }
  bool within(std::int64_t value, std::int64_t least, std::int64_t end, const char* what, std::int64_t which = -1) {
    return require(least <= value && value < end, what, which);
  }
  bool geometry(std::int64_t at, std::int64_t count, const char* what, std::int64_t which = -1) {
    return lies(at, count, packed_.geometry.size(), what, which);
  }
  bool shading(std::int64_t at, std::int64_t count, const char* what, std::int64_t which = -1) {
    return lies(at, count, packed_.shading.size(), what, which);
  }
  bool index(std::int64_t at, std::int64_t count, const char* what, std::int64_t which = -1) {
    return lies(at, count, packed_.index.size(), what, which);
  }

  /// Of a place that was found to lie in the buffer.
  [[nodiscard]] std::int32_t at(std::int64_t place) const { return packed_.index[static_cast<std::size_t>(place)]; }
  /// `count` rows of `ints` each; empty after a fault.
  [[nodiscard]] std::span<const std::int32_t> rows(std::int64_t first, std::int64_t count, std::int64_t ints,
                                                   const char* what) {
    if (count == 0 || !index(first, count * ints, what)) return {};
    return std::span(packed_.index).subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(count * ints));
  }
  [[nodiscard]] const PackedScene<Real>& packed() const { return packed_; }

 private:
  bool lies(std::int64_t at, std::int64_t count, std::size_t size, const char* what, std::int64_t which) {
    return require(at >= 0 && count >= 0 && at + count <= static_cast<std::int64_t>(size), what, which);
  }

  const PackedScene<Real>& packed_;
  std::string fault_;
};

/// The parts of check_packed, each in its file; what they find is in `ranges`.
struct PackedPart {
  std::int64_t first_id, primitives;  ///< Of its shape.
  bool has_frame, is_mesh;
};
struct PackedFacts {
  const Scene& scene;
  const Features& features;
  const PackOptions& options;
  std::vector<PackedPart> parts;
  std::int64_t texture_rows = 0;

  [[nodiscard]] std::int64_t count(const std::string& list) const;  ///< Of active entries.
};
/// most_rows: of a grid, whose layers lie one below the other, as many as there may be texels.
template <typename Real>
void check_image(PackedRanges<Real>& ranges, std::int64_t row, std::int64_t most_rows = longest_side);
template <typename Real>
void check_textures(PackedRanges<Real>& ranges, const PackedFacts& facts);
template <typename Real>
void check_lights(PackedRanges<Real>& ranges, const PackedFacts& facts);
template <typename Real>
void check_media(PackedRanges<Real>& ranges, const PackedFacts& facts);
template <typename Real>
void check_trees(PackedRanges<Real>& ranges, const PackedFacts& facts);

}  // namespace strahl
