// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>

#include "kinds/textures.h"
#include "packing/cl_layout.h"
#include "packing/entry_numbers.h"
#include "packing/packed_ranges.h"

namespace strahl {
namespace {

struct Kind {
  std::int64_t reals;
  bool is_bitmap, is_attribute;
};

/// What each kind of texture of the scene reads, by its number.
std::map<int, Kind> kinds_of(const PackedFacts& facts) {
  std::map<int, Kind> kinds;
  EntryNumbers numbers(facts.features);
  for (const Texture& texture : facts.scene.textures) {
    const kinds::TextureFacts is = kinds::texture(texture);
    kinds[numbers("textures", is.entry)] = {static_cast<std::int64_t>(is.reals.size()), is.bitmap != nullptr,
                                            !is.attribute.empty()};
  }
  return kinds;
}

/// Of a mesh: two ints for each of `count` attributes.
template <typename Real>
void check_attributes(PackedRanges<Real>& ranges, const PackedFacts& facts, std::int64_t count) {
  for (std::size_t i = 0; i < facts.parts.size() && ranges.fault().empty(); ++i) {
    const auto part = static_cast<std::int64_t>(i);
    const int at = ranges.at(ranges.at(layout::HEADER_PARTS) + part * layout::PART_INTS + layout::PART_ATTRIBUTES);
    if (at == -1 || !ranges.index(at, 2 * count, "the attributes of part", part)) continue;
    for (std::int64_t k = 0; k < count; ++k) {
      const int reals = ranges.at(at + 2 * k + 1);
      ranges.require(reals == 0 || reals == 3 || reals == 9, "an attribute of part", part);
      if (reals != 0)
        ranges.shading(ranges.at(at + 2 * k), reals * facts.parts[i].primitives, "the attributes of part", part);
    }
  }
}

}  // namespace

template <typename Real>
void check_image(PackedRanges<Real>& ranges, std::int64_t row, std::int64_t most_rows) {
  if (!ranges.index(row, layout::IMAGE_INTS, "an image at", row)) return;
  const std::int64_t width = ranges.at(row + layout::IMAGE_WIDTH), height = ranges.at(row + layout::IMAGE_HEIGHT);
  const std::int64_t texels = ranges.at(row + layout::IMAGE_TEXELS), table = ranges.at(row + layout::IMAGE_TABLE);
  if (!ranges.within(width, 1, longest_side + 1, "the width of the image at", row) ||
      !ranges.within(height, 1, most_rows + 1, "the height of the image at", row))
    return;
  const std::int64_t count = width * height;
  const auto ints = [&](std::int64_t size, std::int64_t codes) {
    ranges.index(texels, size, "the texels of the image at", row);
    if (codes > 0) ranges.shading(table, codes, "the table of the image at", row);
  };
  switch (ranges.at(row + layout::IMAGE_FORMAT)) {
    case layout::TEXELS_GREY_8:
      return ints((count + 3) / 4, 256);
    case layout::TEXELS_GREY_16:
      return ints((count + 1) / 2, 65536);
    case layout::TEXELS_GREY_HALF:
      return ints((count + 1) / 2, 0);
    case layout::TEXELS_RGB_8:
      return ints(count, 256);
    case layout::TEXELS_RGBE:
      return ints(count, 0);
    case layout::TEXELS_RGB_HALF:
      return ints(2 * count, 0);
    case layout::TEXELS_RGB_16: {
      ints(2 * count, 65536);
      // Its blue is a code by itself.
      for (std::int64_t i = 0; i < count && ranges.fault().empty(); ++i)
        ranges.within(ranges.at(texels + 2 * i + 1), 0, 65536, "a texel of the image at", row);
      return;
    }
    case layout::TEXELS_GREY_REAL:
    case layout::TEXELS_RGB_REAL: {
      const bool is_grey = ranges.at(row + layout::IMAGE_FORMAT) == layout::TEXELS_GREY_REAL;
      ranges.shading(texels, (is_grey ? count : 3 * count) + 1, "the texels of the image at", row);
      return;
    }
    default:
      ranges.require(false, "the format of the image at", row);
  }
}

template <typename Real>
void check_textures(PackedRanges<Real>& ranges, const PackedFacts& facts) {
  const auto rows =
      ranges.rows(ranges.at(layout::HEADER_TEXTURES), facts.texture_rows, layout::TEXTURE_INTS, "the textures");
  if (rows.empty()) return;
  const std::map<int, Kind> kinds = kinds_of(facts);
  std::int64_t attributes = 0;
  for (std::int64_t i = 0; i < facts.texture_rows; ++i) {
    const auto row = rows.subspan(static_cast<std::size_t>(i) * layout::TEXTURE_INTS, layout::TEXTURE_INTS);
    const auto kind = kinds.find(row[layout::TEXTURE_KIND]);
    if (!ranges.require(kind != kinds.end(), "the kind of texture", i)) return;
    ranges.shading(row[layout::TEXTURE_REALS], kind->second.reals, "the parameters of texture", i);
    const std::int64_t image = row[layout::TEXTURE_IMAGE];
    if (kind->second.is_attribute && kind->first >= 0 &&
        ranges.within(image, 0, static_cast<std::int64_t>(facts.scene.textures.size()), "the attribute of texture", i))
      attributes = std::max(attributes, image + 1);
    if (!kind->second.is_bitmap || kind->first < 0) continue;
    // As many as an int has bits: the width of a texel of the last is a power of two.
    if (!ranges.within(row[layout::TEXTURE_LEVELS], 1, 31, "the levels of texture", i)) return;
    for (std::int64_t level = 0; level < row[layout::TEXTURE_LEVELS]; ++level)
      check_image(ranges, image + level * layout::IMAGE_INTS);
  }
  if (ranges.fault().empty()) check_attributes(ranges, facts, attributes);
}

template void check_image(PackedRanges<float>&, std::int64_t, std::int64_t);
template void check_image(PackedRanges<double>&, std::int64_t, std::int64_t);
template void check_textures(PackedRanges<float>&, const PackedFacts&);
template void check_textures(PackedRanges<double>&, const PackedFacts&);

}  // namespace strahl
