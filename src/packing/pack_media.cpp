// SPDX-License-Identifier: MIT
#include "packing/pack_media.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "kinds/entries.h"
#include "kinds/integrators.h"
#include "packing/cl_layout.h"

namespace strahl {

template <typename Real>
void pack_media(PackedScene<Real>& packed, int row, const Scene& scene, const Features& features,
                const UploadFrame& frame, const std::vector<std::optional<MediumBoundary>>& boundaries) {
  const bool has_media = kinds::integrator(scene.integrator.name).goes_through;
  const double most = std::numeric_limits<Real>::max();
  std::vector<std::int32_t> rows, sides;
  for (const Medium& medium : scene.media) {
    const Rgb& s = medium.sigma_t;
    std::vector<double> reals;
    for (const double sigma : {s.r, s.g, s.b}) reals.push_back(std::min(sigma / frame.scale, most));
    for (const Rgb& c : {medium.albedo, medium.emission}) reals.insert(reals.end(), {c.r, c.g, c.b});
    std::vector<std::int32_t> phases;
    for (const PhaseFunction& phase : medium.phases)
      phases.insert(phases.end(), {features.entry_index("phases", phase_entry(phase.kind)),
                                   packed.put_shading({phase.share, phase.g})});
    rows.insert(rows.end(),
                {features.entry_index("media", "homogeneous"), packed.put_shading(reals),
                 s.r == s.g && s.g == s.b ? 1 : 0, packed.put_index(phases), checked_offset(medium.phases.size())});
  }
  for (const auto& boundary : boundaries) {
    const MediumBoundary none{layout::MEDIUM_SAME, layout::MEDIUM_SAME};
    const MediumBoundary& at = has_media && boundary ? *boundary : none;
    sides.insert(sides.end(), {at.inside, at.outside});
  }
  const int rows_at = packed.put_index(rows), sides_at = packed.put_index(sides);
  packed.at(row + layout::MEDIA_ROWS) = rows_at;
  packed.at(row + layout::MEDIA_PARTS) = sides_at;
  packed.at(row + layout::MEDIA_CAMERA) = has_media ? scene.camera.medium : layout::MEDIUM_NONE;
}

template void pack_media(PackedScene<float>&, int, const Scene&, const Features&, const UploadFrame&,
                         const std::vector<std::optional<MediumBoundary>>&);
template void pack_media(PackedScene<double>&, int, const Scene&, const Features&, const UploadFrame&,
                         const std::vector<std::optional<MediumBoundary>>&);

}  // namespace strahl
