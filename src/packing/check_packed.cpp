// SPDX-License-Identifier: MIT
#include "packing/check_packed.h"

#include <stdexcept>
#include <vector>

#include "kinds/entries.h"
#include "kinds/integrators.h"
#include "packing/cl_layout.h"
#include "packing/pack_filter.h"
#include "packing/pack_instances.h"
#include "packing/pack_shapes.h"
#include "packing/packed_ranges.h"
#include "packing/path_lengths.h"
#include "packing/shape_parts.h"
#include "settings/sampling.h"

namespace strahl {

std::int64_t PackedFacts::count(const std::string& list) const {
  const auto found = features.entries.find(list);
  return found == features.entries.end() ? 0 : static_cast<std::int64_t>(found->second.size());
}

namespace {

std::vector<PackedPart> parts_of(const Scene& scene, const UploadFrame& frame) {
  std::vector<PackedPart> parts;
  std::int64_t first_id = 0;
  for_each_shape(scene, [&](const Shape& shape) {
    const PackedPart part{first_id, primitive_count(shape), surface_frame(shape.geometry, frame).has_value(),
                          std::holds_alternative<Mesh>(shape.geometry)};
    parts.insert(parts.end(), static_cast<std::size_t>(part_count(shape)), part);
    first_id += part.primitives;
  });
  return parts;
}

/// What is no offset is what the scene says: it decides when loops end.
template <typename Real>
void check_header(PackedRanges<Real>& ranges, const PackedFacts& facts) {
  const Scene& scene = facts.scene;
  const SamplerKind sampler = resolve_sampling(scene).kind;
  const auto is = [&](int field, std::int64_t value, const char* what) {
    ranges.require(ranges.at(field) == value, what);
  };
  is(layout::HEADER_WIDTH, scene.film.width, "the width");
  is(layout::HEADER_FILM_ROWS, scene.film.window().height(), "the film's rows");
  is(layout::HEADER_SUMS, 1, "the sums");
  is(layout::HEADER_SEQUENCES, 1, "the sequences");
  is(layout::HEADER_TURN_BITS, 0, "the turns");
  is(layout::HEADER_INTEGRATOR, facts.features.entry_index("integrators", scene.integrator.name), "the integrator");
  is(layout::HEADER_MAX_DEPTH, most_surfaces(scene.integrator), "the depth");
  const std::int64_t glowing = ranges.at(layout::HEADER_GLOWING_COUNT);
  ranges.within(ranges.at(layout::HEADER_LAST_DEPTH), -1, std::int64_t{1} << 31, "the depth of last rays");
  if (ranges.within(glowing, 0, static_cast<std::int64_t>(scene.shapes.size()) + 1, "the boxes of emission"))
    ranges.shading(ranges.at(layout::HEADER_GLOWING), 6 * glowing, "the boxes of emission");
  is(layout::HEADER_RR_DEPTH, scene.integrator.rr_depth, "the depth of roulette");
  is(layout::HEADER_SAMPLER, facts.features.entry_index("samplers", sampler_entry(sampler)), "the sampler");
  ranges.shading(ranges.at(layout::HEADER_REACH), 1, "the reach");
  ranges.shading(ranges.at(layout::HEADER_CAMERA), layout::CAMERA_REALS, "the camera");
  ranges.shading(ranges.at(layout::HEADER_FILTER), layout::FILTER_CELLS + 1, "the filter");
  const kinds::FilterTaps taps = taps_of(scene, facts.features);
  is(layout::HEADER_TAP_SIDES, taps.sides, "the filter's sides");
  is(layout::HEADER_TAP_REACH, taps.reach, "the filter's reach");
  ranges.shading(ranges.at(layout::HEADER_TAPS), static_cast<std::int64_t>(taps.terms.size()), "the filter's taps");
  const int sensor = ranges.at(layout::HEADER_SENSOR);
  const bool is_read = kinds::integrator(scene.integrator.name).from_lights;
  if (is_read || sensor != -1)
    ranges.shading(sensor, int{layout::SENSOR_REALS} + int{layout::FILTER_CELLS} + 1, "the sensor");
  if (!is_read || !ranges.fault().empty()) return;
  // From other numbers kernels would compute a place in the filter's table that is none.
  const Real* const reals = ranges.packed().shading.data() + sensor;
  ranges.require(
      reals[layout::SENSOR_HEIGHT] == static_cast<Real>(scene.film.height) &&
          reals[layout::SENSOR_FILTER_HALF] == static_cast<Real>(filter_densities(scene.film.filter).half_width),
      "the sensor's size");
}

template <typename Real>
void check_parts(PackedRanges<Real>& ranges, const PackedFacts& facts) {
  const auto count = static_cast<std::int64_t>(facts.parts.size());
  const auto rows = ranges.rows(ranges.at(layout::HEADER_PARTS), count, layout::PART_INTS, "the parts");
  if (rows.empty()) return;
  const auto materials = static_cast<std::int64_t>(facts.scene.materials.size());
  for (std::int64_t i = 0; i < count; ++i) {
    const auto row = rows.subspan(static_cast<std::size_t>(i) * layout::PART_INTS, layout::PART_INTS);
    const PackedPart& part = facts.parts[static_cast<std::size_t>(i)];
    // -1: not there.
    const auto reals = [&](std::size_t field, std::int64_t size, bool is_needed, const char* what) {
      if (is_needed || row[field] != -1) ranges.shading(row[field], size, what, i);
    };
    ranges.require(row[layout::PART_FIRST_ID] == part.first_id, "the first id of part", i);
    ranges.within(row[layout::PART_MATERIAL], 0, materials, "the material of part", i);
    reals(layout::PART_RADIANCE, 3, false, "the radiance of part");
    ranges.within(row[layout::PART_GLOW], -1, facts.texture_rows, "the texture of the light of part", i);
    ranges.within(row[layout::PART_LIGHT], -1, ranges.at(layout::HEADER_LIGHT_COUNT), "the light of part", i);
    reals(layout::PART_AXES, 9, part.has_frame, "the axes of part");
    // With texture coordinates of its own a part is read as one of triangles.
    for (const std::size_t field : {layout::PART_NORMALS, layout::PART_UVS, layout::PART_ATTRIBUTES})
      ranges.require(part.is_mesh || row[field] == -1, "what only meshes have, of part", i);
    reals(layout::PART_NORMALS, 9 * part.primitives, false, "the normals of part");
    reals(layout::PART_UVS, 6 * part.primitives, false, "the texture coordinates of part");
    reals(layout::PART_UV_RATES, 2, facts.texture_rows > 0 && facts.count("textures") > 0,
          "the rates of texture coordinates of part");
  }
}

/// A row's way through rows within rows comes to an end: none leads back to itself.
bool ends(const std::vector<std::vector<std::int32_t>>& inner) {
  enum class State : char { fresh, open, done };
  std::vector<State> states(inner.size(), State::fresh);
  std::vector<std::pair<std::size_t, std::size_t>> way;  // A row, and which of those within it is next.
  for (std::size_t first = 0; first < inner.size(); ++first) {
    if (states[first] == State::fresh) way.emplace_back(first, 0);
    while (!way.empty()) {
      auto& [row, next] = way.back();
      states[row] = next < inner[row].size() ? State::open : State::done;
      if (states[row] == State::done) {
        way.pop_back();
        continue;
      }
      const auto within = static_cast<std::size_t>(inner[row][next++]);
      if (states[within] == State::open) return false;
      if (states[within] == State::fresh) way.emplace_back(within, 0);
    }
  }
  return true;
}

template <typename Real>
void check_materials(PackedRanges<Real>& ranges, const PackedFacts& facts) {
  const auto count = static_cast<std::int64_t>(facts.scene.materials.size());
  const auto rows = ranges.rows(ranges.at(layout::HEADER_MATERIALS), count, layout::MATERIAL_INTS, "the materials");
  if (rows.empty()) return;
  const auto entry = [&](std::int64_t row, int field) {
    return rows[static_cast<std::size_t>(row * layout::MATERIAL_INTS + field)];
  };
  for (std::int64_t i = 0; i < count; ++i) {
    ranges.within(entry(i, layout::MATERIAL_KIND), -1, facts.count("materials"), "the kind of material", i);
    ranges.within(entry(i, layout::MATERIAL_BACK), -1, count, "what is behind material", i);
    ranges.within(entry(i, layout::MATERIAL_FIRST), -1, count, "what is within material", i);
    ranges.within(entry(i, layout::MATERIAL_SECOND), -2, count, "what else is within material", i);
    for (int slot = -1; slot < layout::MATERIAL_MOST_SLOTS; ++slot) {
      const int at = entry(i, slot < 0 ? int{layout::MATERIAL_OPACITY} : layout::MATERIAL_SLOTS + slot);
      if (at < 0)
        ranges.within(~at, 0, facts.texture_rows, "a texture of material", i);
      else
        ranges.shading(at, 3, "a parameter of material", i);
    }
  }
  if (!ranges.fault().empty()) return;
  std::vector<std::vector<std::int32_t>> inner(static_cast<std::size_t>(count));
  for (std::int64_t i = 0; i < count; ++i)
    for (const std::int64_t seen : {i, std::int64_t{entry(i, layout::MATERIAL_BACK)}})
      for (const int field : {layout::MATERIAL_FIRST, layout::MATERIAL_SECOND})
        if (seen >= 0 && entry(seen, layout::MATERIAL_FIRST) >= 0 && entry(seen, field) >= 0)
          inner[static_cast<std::size_t>(i)].push_back(entry(seen, field));
  ranges.require(ends(inner), "a material lies within itself");
}

}  // namespace

template <typename Real>
std::string fault_of_packed(const PackedScene<Real>& packed, const Scene& scene, const Features& features,
                            const PackOptions& options) {
  PackedFacts facts{scene, features, options, parts_of(scene, options.frame)};
  facts.texture_rows = static_cast<std::int64_t>(scene.textures.size()) * (features.flag("TEXTURE_LOD") ? 2 : 1);
  PackedRanges<Real> ranges(packed);
  const std::int64_t rows = facts.count("shapes") + (features.flag("INSTANCES") ? 1 : 0);
  const std::int64_t media = features.flag("MEDIA") ? int{layout::MEDIA_INTS} : 0;
  if (!ranges.index(0, layout::HEADER_INTS + rows * layout::SHAPE_INTS + media, "the header")) return ranges.fault();
  check_header(ranges, facts);
  check_parts(ranges, facts);
  check_materials(ranges, facts);
  check_textures(ranges, facts);
  check_lights(ranges, facts);
  check_trees(ranges, facts);
  if (media > 0) check_media(ranges, facts);
  return ranges.fault();
}

template <typename Real>
void check_packed(const PackedScene<Real>& packed, const Scene& scene, const Features& features,
                  const PackOptions& options) {
  const std::string fault = fault_of_packed(packed, scene, features, options);
  if (!fault.empty()) throw std::logic_error("a packed scene that kernels could not read: " + fault);
}

template std::string fault_of_packed(const PackedScene<float>&, const Scene&, const Features&, const PackOptions&);
template std::string fault_of_packed(const PackedScene<double>&, const Scene&, const Features&, const PackOptions&);
template void check_packed(const PackedScene<float>&, const Scene&, const Features&, const PackOptions&);
template void check_packed(const PackedScene<double>&, const Scene&, const Features&, const PackOptions&);

}  // namespace strahl
