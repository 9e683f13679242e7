// SPDX-License-Identifier: MIT
#include "kinds/entries.h"
#include "packing/cl_layout.h"
#include "packing/packed_ranges.h"

namespace strahl {
namespace {

/// The greatest number of cells along an axis that a float tells apart.
constexpr std::int64_t most_cells = std::int64_t{1} << 24;

template <typename Real>
void check_volume(PackedRanges<Real>& ranges, std::int64_t row, std::int64_t medium) {
  ranges.shading(ranges.at(row + layout::VOLUME_REALS), layout::VOLUME_REAL_COUNT, "a volume of medium", medium);
  const std::int64_t image = ranges.at(row + layout::VOLUME_IMAGE);
  if (image == -1) return;
  // The image has its layers one below the other.
  check_image(ranges, image, most_texels);
  if (!ranges.fault().empty()) return;
  const std::int64_t height = ranges.at(row + layout::VOLUME_HEIGHT), depth = ranges.at(row + layout::VOLUME_DEPTH);
  if (ranges.within(height, 1, longest_side + 1, "the size of a volume of medium", medium) &&
      ranges.within(depth, 1, longest_side + 1, "the size of a volume of medium", medium))
    ranges.require(height * depth <= ranges.at(image + layout::IMAGE_HEIGHT), "the size of a volume of medium", medium);
}

template <typename Real>
void check_varying(PackedRanges<Real>& ranges, std::int64_t row, std::int64_t medium) {
  const std::int64_t volumes = ranges.at(row + layout::MEDIUM_VOLUMES);
  const std::int64_t cells = ranges.at(row + layout::MEDIUM_MAJORANTS);
  if (!ranges.index(volumes, int{layout::VOLUMES_A_MEDIUM} * int{layout::VOLUME_INTS}, "the volumes of medium", medium))
    return;
  for (int i = 0; i < layout::VOLUMES_A_MEDIUM; ++i) check_volume(ranges, volumes + i * layout::VOLUME_INTS, medium);
  if (!ranges.index(cells, layout::MAJORANT_INTS, "the cells of medium", medium)) return;
  ranges.shading(ranges.at(cells + layout::MAJORANT_REALS), layout::MAJORANT_REAL_COUNT, "the cells of medium", medium);
  std::int64_t count = 1;
  for (const int side : {layout::MAJORANT_WIDTH, layout::MAJORANT_HEIGHT, layout::MAJORANT_DEPTH}) {
    if (!ranges.within(ranges.at(cells + side), 1, most_cells + 1, "the cells of medium", medium)) return;
    count *= ranges.at(cells + side);
    if (!ranges.require(count <= std::int64_t{1} << 31, "the cells of medium", medium)) return;
  }
  ranges.shading(ranges.at(cells + layout::MAJORANT_MOST), count, "the cells of medium", medium);
}

}  // namespace

template <typename Real>
void check_media(PackedRanges<Real>& ranges, const PackedFacts& facts) {
  if (!ranges.fault().empty()) return;
  const std::int64_t rows = facts.count("shapes") + (facts.features.flag("INSTANCES") ? 1 : 0);
  const std::int64_t table = layout::HEADER_INTS + rows * layout::SHAPE_INTS;
  const auto count = static_cast<std::int64_t>(facts.scene.media.size());
  const auto parts = static_cast<std::int64_t>(facts.parts.size());
  const std::int64_t first = ranges.at(table + layout::MEDIA_ROWS), sides = ranges.at(table + layout::MEDIA_PARTS);
  ranges.within(ranges.at(table + layout::MEDIA_CAMERA), -1, count, "the medium of the camera");
  ranges.shading(ranges.at(table + layout::MEDIA_BALL), layout::BALL_REALS, "the ball around the scene");
  if (ranges.index(sides, parts * layout::BOUNDARY_INTS, "the media of parts"))
    for (std::int64_t i = 0; i < parts * layout::BOUNDARY_INTS; ++i)
      ranges.within(ranges.at(sides + i), -2, count, "the media of part", i / layout::BOUNDARY_INTS);
  if (!ranges.index(first, count * layout::MEDIUM_INTS, "the media")) return;
  const int varying = facts.features.entry_index("media", "heterogeneous");
  for (std::int64_t i = 0; i < count && ranges.fault().empty(); ++i) {
    const std::int64_t row = first + i * layout::MEDIUM_INTS;
    const int kind = ranges.at(row + layout::MEDIUM_KIND);
    ranges.within(kind, -1, facts.count("media"), "the kind of medium", i);
    ranges.shading(ranges.at(row + layout::MEDIUM_REALS), layout::MEDIUM_REAL_COUNT, "the parameters of medium", i);
    const std::int64_t phases = ranges.at(row + layout::MEDIUM_PHASES);
    const std::int64_t phase_count = ranges.at(row + layout::MEDIUM_PHASE_COUNT);
    if (!ranges.index(phases, phase_count * layout::PHASE_INTS, "the phase functions of medium", i)) return;
    for (std::int64_t k = 0; k < phase_count; ++k) {
      ranges.within(ranges.at(phases + k * layout::PHASE_INTS + layout::PHASE_KIND), -1, facts.count("phases"),
                    "a phase function of medium", i);
      ranges.shading(ranges.at(phases + k * layout::PHASE_INTS + layout::PHASE_REALS), 2, "a phase function of medium",
                     i);
    }
    if (kind >= 0 && kind == varying) check_varying(ranges, row, i);
  }
}

template void check_media(PackedRanges<float>&, const PackedFacts&);
template void check_media(PackedRanges<double>&, const PackedFacts&);

}  // namespace strahl
