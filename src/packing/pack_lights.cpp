// SPDX-License-Identifier: MIT
#include "packing/pack_lights.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <variant>

#include "kinds/entries.h"
#include "kinds/integrators.h"
#include "kinds/lights.h"
#include "packing/cl_layout.h"
#include "packing/entry_numbers.h"
#include "packing/light_textures.h"
#include "packing/pack_areas.h"
#include "packing/pack_chooser.h"
#include "packing/pack_environment.h"
#include "packing/shape_parts.h"

namespace strahl {
namespace {

/// Of a surface that shines along its normals alone, from that of one that shines in all directions.
LightReach along_normals(LightReach reach) {
  reach.power /= std::numbers::pi;
  reach.cutoff = 0;
  return reach;
}

template <typename Real>
class LightTable {
 public:
  LightTable(PackedScene<Real>& packed, PackedImages<Real>& images, const Scene& scene, const Features& features,
             const UploadFrame& frame)
      : packed_(packed), images_(images), scene_(scene), features_(features), frame_(frame) {}

  /// Those that are taken, those that are drawn, and those that rays only find.
  std::vector<int> run(const std::vector<const Shape*>& shapes, const std::vector<std::int32_t>& first_ids) {
    header(layout::HEADER_BACKGROUND) = header(layout::HEADER_SUN) = -1;
    const kinds::IntegratorFacts& integrator = kinds::integrator(scene_.integrator.name);
    const auto is_taken = [&](const Light& light) {
      return kinds::light(light).is_delta && integrator.lamps == kinds::Lamps::taken;
    };
    const auto is_drawn = [&](const Light& light) { return kinds::is_drawn(light, scene_) && !is_taken(light); };
    put_lights(is_taken);
    const int taken = count();
    put_lights([&](const Light& light) { return is_drawn(light) && kinds::light(light).is_delta; });
    put_lights([&](const Light& light) { return is_drawn(light) && !kinds::light(light).is_delta; });
    area_lights(shapes, first_ids);
    header(layout::HEADER_LIGHTS_TAKEN) = taken;
    header(layout::HEADER_LIGHT_COUNT) = count();
    pack_chooser(packed_, scene_, features_, frame_, std::span(reaches_).subspan(static_cast<std::size_t>(taken)));
    put_lights([&](const Light& light) { return !is_drawn(light) && kinds::light(light).is_background; });
    const int rows_at = packed_.put_index(rows_);
    header(layout::HEADER_LIGHTS) = rows_at;
    return std::move(light_of_part_);
  }

 private:
  std::int32_t& header(int field) { return packed_.at(field); }
  [[nodiscard]] bool begins_paths() const { return kinds::integrator(scene_.integrator.name).from_lights; }
  [[nodiscard]] int count() const { return static_cast<int>(rows_.size()) / layout::LIGHT_INTS; }

  /// LIGHT_ALIKE of the next row.
  int alike(bool is_alike, int kind, int area) {
    return is_alike ? first_alike_.try_emplace({kind, area}, count()).first->second : count();
  }

  template <typename IsMeant>
  void put_lights(const IsMeant& is_meant) {
    for (const Light& light : scene_.lights)
      if (is_meant(light)) put_light(light);
  }

  /// Not where the program has no use for it.
  void put_light(const Light& from) {
    const kinds::LightFacts& facts = kinds::light(from);
    if (facts.is_beam && !begins_paths()) return;
    const int kind = numbers_("lights", light_kind(from));
    if (kind < 0) return;
    if (facts.is_background) header(facts.is_sun ? layout::HEADER_SUN : layout::HEADER_BACKGROUND) = count();
    Light light = from;
    const TexturedColour colour =
        textured_colour(kinds::light_colour(from), kinds::light_texture(from), scene_, features_);
    kinds::light_colour(light) = colour.colour;
    if (kinds::light_glows(light)) header(layout::HEADER_GLOWS) = 1;
    rows_.insert(rows_.end(), {kind, packed_.put_shading(kinds::light_reals(light, frame_)), 0, 0, 0, -1, colour.row,
                               -1, -1, alike(facts.is_alike && colour.row < 0, kind, 0)});
    // That of an image reads all of its texels.
    const bool is_chosen = features_.light_chooser != "uniform";
    kinds::light_colour(light) = colour.mean;
    reaches_.push_back(is_chosen ? kinds::light_reach(light, frame_) : LightReach{});
    if (const auto* environment = std::get_if<EnvironmentLight>(&light.emitter)) put_environment(*environment);
  }

  /// Behind its reals, and into the last row and reach.
  void put_environment(const EnvironmentLight& light) {
    const EnvironmentTables tables = environment_tables(light, kinds::finds_all_emission(scene_));
    reaches_.back().power *= tables.drawn;
    reaches_.back().intensity *= tables.drawn;
    packed_.put_shading({tables.floor});
    packed_.put_shading(tables.rows);
    const std::span row = std::span(rows_).last(layout::LIGHT_INTS);
    row[layout::LIGHT_IMAGE] = images_.row(*light.texels, light.curve);
    row[layout::LIGHT_CHOICE] = put_choices(packed_, tables.choices);
  }

  void glow(const Rgb& radiance) {
    if (radiance.r > 0 || radiance.g > 0 || radiance.b > 0) header(layout::HEADER_GLOWS) = 1;
  }

  /// One for each part that emits, may be drawn and has an area that can be drawn from; light_of_part_ for each part of
  /// the scene.
  void area_lights(const std::vector<const Shape*>& shapes, const std::vector<std::int32_t>& first_ids) {
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      const Shape& shape = *shapes[i];
      const bool glows = features_.flag("EMISSION") && features_.has("shapes", shape_kind(shape));
      const bool is_beam = shape.exitance.has_value();
      const int kind = numbers_("lights", is_beam ? "directionalarea" : "area");
      std::optional<PrimitivesOfParts> primitives;  // Of a shape that is drawn.
      const bool is_drawn = kind >= 0 && shape.sampling_weight > 0 && features_.has("areas", area_kind(shape.geometry));
      for (int part = 0; part < part_count(shape); ++part) {
        light_of_part_.push_back(-1);
        const MeshPart look = look_of_part(shape, part);
        if (is_beam ? !begins_paths() : !look.radiance || !glows) continue;
        const TexturedColour radiance =
            textured_colour(is_beam ? *shape.exitance : *look.radiance,
                            is_beam ? shape.radiance_texture : look.radiance_texture, scene_, features_);
        if (!is_beam) glow(radiance.colour);
        if (!is_drawn) continue;
        const kinds::UvSource uv_source = radiance.row < 0             ? kinds::UvSource::none
                                          : features_.flag("MESH_UVS") ? kinds::UvSource::mesh
                                                                       : kinds::UvSource::parameters;
        if (!primitives) primitives.emplace(shape);
        const std::optional<EmittingArea> area =
            emitting_area(shape, primitives->of(part), radiance.mean, uv_source, frame_);
        if (!area) continue;
        if (!is_beam) light_of_part_.back() = count();
        reaches_.push_back(is_beam ? along_normals(area->reach) : area->reach);
        const Rgb& colour = radiance.colour;
        std::vector<double> reals = {colour.r, colour.g, colour.b, 1 / area->size, area->side};
        reals.insert(reals.end(), area->items.begin(), area->items.end());
        const int items = checked_offset(area->choices.size());
        header(layout::HEADER_MOST_ITEMS) = std::max(header(layout::HEADER_MOST_ITEMS), items);
        const int choice_at = put_choices(packed_, area->choices);
        const int first = first_of_area(shape.geometry, part, area->side < 0);
        const int area_number = numbers_("areas", area_kind(shape.geometry));
        const int uvs_at = area->uvs.empty() ? -1 : packed_.put_shading(area->uvs);
        rows_.insert(rows_.end(), {kind, packed_.put_shading(reals), area_number, items, choice_at,
                                   first < 0 ? -1 : first_ids[i] + first, radiance.row, uvs_at,
                                   static_cast<int>(light_of_part_.size()) - 1,
                                   alike(!is_beam && items == 1 && radiance.row < 0, kind, area_number)});
      }
    }
  }

  PackedScene<Real>& packed_;
  PackedImages<Real>& images_;
  const Scene& scene_;
  const Features& features_;
  const UploadFrame& frame_;
  std::vector<std::int32_t> rows_;
  std::map<std::pair<int, int>, int> first_alike_;  ///< By kind and area.
  std::vector<LightReach> reaches_;                 ///< One a row.
  EntryNumbers numbers_{features_};
  std::vector<int> light_of_part_;
};

}  // namespace

template <typename Real>
std::vector<int> pack_lights(PackedScene<Real>& packed, PackedImages<Real>& images, const Scene& scene,
                             const Features& features, const UploadFrame& frame,
                             const std::vector<const Shape*>& shapes, const std::vector<std::int32_t>& first_ids) {
  return LightTable<Real>(packed, images, scene, features, frame).run(shapes, first_ids);
}

template std::vector<int> pack_lights(PackedScene<float>&, PackedImages<float>&, const Scene&, const Features&,
                                      const UploadFrame&, const std::vector<const Shape*>&,
                                      const std::vector<std::int32_t>&);
template std::vector<int> pack_lights(PackedScene<double>&, PackedImages<double>&, const Scene&, const Features&,
                                      const UploadFrame&, const std::vector<const Shape*>&,
                                      const std::vector<std::int32_t>&);

}  // namespace strahl
