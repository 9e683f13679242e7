// SPDX-License-Identifier: MIT
#include "packing/pack_media.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "kinds/entries.h"
#include "kinds/integrators.h"
#include "packing/cl_layout.h"
#include "packing/majorants.h"
#include "scene/open_media.h"
#include "scene/unseen.h"

namespace strahl {
namespace {

bool is_grey(const Rgb& c) { return c.r == c.g && c.g == c.b; }
bool is_grey(const Volume& volume) { return is_grey(volume.value) && (!volume.grid || volume.grid->texels.is_grey); }
bool is_black(const Volume& volume) {
  const Rgb c = volume.largest();
  return c.r == 0 && c.g == 0 && c.b == 0;
}

/// VOLUME_INTS. scale: multiplies the values.
template <typename Real>
std::vector<std::int32_t> volume_row(PackedScene<Real>& packed, PackedImages<Real>& images, const Volume& volume,
                                     const UploadFrame& frame, double scale) {
  constexpr double most = std::numeric_limits<Real>::max();
  const Rgb& value = volume.value;
  std::vector<double> reals = box_frame(volume.world_from_cube, frame, {1, 1, 1}, {0.5, 0.5, 0.5});
  for (const double c : {value.r, value.g, value.b}) reals.push_back(std::min(scale * c, most));
  const int reals_at = packed.put_shading(reals);
  if (!volume.grid) return {reals_at, -1, 0, 0, 0, 0};
  const VolumeGrid& grid = *volume.grid;
  const int filter = volume.filter == TextureFilter::nearest ? layout::FILTER_NEAREST : layout::FILTER_BILINEAR;
  return {reals_at,    images.row(grid.texels, {TexelCurve::Kind::linear, 1}),
          grid.height, grid.depth,
          filter,      static_cast<int>(volume.wrap)};
}

/// Whether light passes, as it came, surfaces that do not stand apart.
bool has_veils(const Scene& scene, const Features& features) {
  if (features.flag("PANE") && has_panes(scene)) return true;
  if (!features.flag("MASK")) return false;
  const auto is_veil = [&](const Shape& shape) { return !is_unseen(shape, scene) && is_masked(shape, scene); };
  return std::any_of(scene.shapes.begin(), scene.shapes.end(), is_veil) ||
         std::any_of(scene.groups.begin(), scene.groups.end(), [&](const Group& group) {
           return std::any_of(group.shapes.begin(), group.shapes.end(),
                              [&](const Shape& shape) { return is_masked(shape, scene); });
         });
}

/// Whether no ray that has left what stands apart meets it again.
bool are_one_convex_body(const Scene& scene) {
  const auto of = [&](const Shape& shape) { return is_unseen(shape, scene); };
  if (std::count_if(scene.shapes.begin(), scene.shapes.end(), of) != 1) return false;
  const Shape& body = *std::find_if(scene.shapes.begin(), scene.shapes.end(), of);
  if (body.flip_normals) return false;
  return std::holds_alternative<Sphere>(body.geometry) || std::holds_alternative<Box>(body.geometry) ||
         std::holds_alternative<Cube>(body.geometry);
}

/// A path may meet as many places as a cell has optical depth before it gets out of it.
void require_passable(const Medium& medium, const Majorants& majorants) {
  constexpr double most_depth = 65536;
  const double most = static_cast<double>(*std::max_element(majorants.most.begin(), majorants.most.end()));
  if (most * majorants.cell <= most_depth) return;
  throw SceneError({{Severity::error, medium.where,
                     fmt::format("sigma_t is so large that a cell of its grid has an optical depth of {:.3g}; up to {} "
                                 "can be followed: lower scale, or the grid's values",
                                 most * majorants.cell, most_depth)}});
}

/// The rows of what varies: MEDIUM_VOLUMES to MEDIUM_EMITS.
template <typename Real>
std::vector<std::int32_t> grid_columns(PackedScene<Real>& packed, PackedImages<Real>& images, const Medium& medium,
                                       const UploadFrame& frame) {
  std::vector<std::int32_t> volumes;
  const auto add = [&](const Volume& volume, double scale) {
    const std::vector<std::int32_t> row = volume_row(packed, images, volume, frame, scale);
    volumes.insert(volumes.end(), row.begin(), row.end());
  };
  add(medium.sigma_t, 1 / frame.scale);
  add(medium.albedo, 1);
  add(medium.emission, 1);
  const Majorants majorants = majorants_of(medium.sigma_t, frame);
  require_passable(medium, majorants);
  const int reals_at = packed.put_shading(majorants.reals), most_at = packed.put_floats(majorants.most);
  const auto [width, height, depth] = majorants.size;
  return {packed.put_index(volumes),
          packed.put_index(std::vector<std::int32_t>{reals_at, most_at, width, height, depth}),
          is_black(medium.albedo) ? 0 : 1, is_black(medium.emission) ? 0 : 1};
}

/// BALL_REALS. Of nothing bounded a point, as in Mitsuba. Where no medium is without an end nothing ends ways: half of
/// `most`, the largest number, as the radius.
std::vector<double> ball_around(const Scene& scene, const UploadFrame& frame, double most) {
  if (!open_medium(scene)) return {0, 0, 0, most / 2};
  const Box box = bounds(scene).value_or(Box{});
  const Vec3 centre = frame.point(0.5 * (box.min + box.max));
  return {centre.x, centre.y, centre.z, frame.scale * 0.5 * length(box.max - box.min)};
}

}  // namespace

bool stands_apart_as_boundary(const Shape& shape, const Scene& scene, const Features& features) {
  return features.flag("MEDIA") && features.flag("MASK") && kinds::integrator(scene.integrator.name).goes_through &&
         is_unseen(shape, scene);
}

template <typename Real>
void pack_media(PackedScene<Real>& packed, PackedImages<Real>& images, int row, const Scene& scene,
                const Features& features, const UploadFrame& frame,
                const std::vector<std::optional<MediumBoundary>>& boundaries) {
  const bool has_media = kinds::integrator(scene.integrator.name).goes_through;
  const double most = std::numeric_limits<Real>::max();
  std::vector<std::int32_t> rows, sides;
  for (const Medium& medium : scene.media) {
    const Rgb &s = medium.sigma_t.value, &albedo = medium.albedo.value, &emission = medium.emission.value;
    std::vector<double> reals;
    for (const double sigma : {s.r, s.g, s.b}) reals.push_back(std::min(sigma / frame.scale, most));
    for (const Rgb& c : {albedo, emission}) reals.insert(reals.end(), {c.r, c.g, c.b});
    std::vector<std::int32_t> phases;
    for (const PhaseFunction& phase : medium.phases)
      phases.insert(phases.end(), {features.entry_index("phases", phase_entry(phase.kind)),
                                   packed.put_shading({phase.share, phase.g})});
    rows.insert(rows.end(), {features.entry_index("media", medium_entry(medium)), packed.put_shading(reals),
                             is_grey(medium.sigma_t) ? 1 : 0, packed.put_index(phases),
                             checked_offset(medium.phases.size()), medium.samples_emitters ? 1 : 0});
    const std::vector<std::int32_t> columns =
        medium.is_heterogeneous() ? grid_columns(packed, images, medium, frame) : std::vector<std::int32_t>(4, 0);
    rows.insert(rows.end(), columns.begin(), columns.end());
  }
  for (const auto& boundary : boundaries) {
    const MediumBoundary none{layout::MEDIUM_SAME, layout::MEDIUM_SAME};
    const MediumBoundary& at = has_media && boundary ? *boundary : none;
    sides.insert(sides.end(), {at.inside, at.outside});
  }
  const int rows_at = packed.put_index(rows), sides_at = packed.put_index(sides);
  packed.at(row + layout::MEDIA_ROWS) = rows_at;
  packed.at(row + layout::MEDIA_PARTS) = sides_at;
  const int ball_at = packed.put_shading(ball_around(scene, frame, most));
  packed.at(row + layout::MEDIA_BALL) = ball_at;
  // Boundaries that stand apart are packed with the shapes.
  packed.at(row + layout::MEDIA_BOUNDARIES) = 0;
  packed.at(row + layout::MEDIA_IS_CONVEX) = are_one_convex_body(scene) ? 1 : 0;
  packed.at(row + layout::MEDIA_VEILS) = has_veils(scene, features) ? 1 : 0;
  packed.at(row + layout::MEDIA_CAMERA) = has_media ? scene.camera.medium : layout::MEDIUM_NONE;
}

template void pack_media(PackedScene<float>&, PackedImages<float>&, int, const Scene&, const Features&,
                         const UploadFrame&, const std::vector<std::optional<MediumBoundary>>&);
template void pack_media(PackedScene<double>&, PackedImages<double>&, int, const Scene&, const Features&,
                         const UploadFrame&, const std::vector<std::optional<MediumBoundary>>&);

}  // namespace strahl
