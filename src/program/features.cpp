// SPDX-License-Identifier: MIT
// One predicate per entry and flag; the first element that calls for an effect is the one reported.
#include "program/features.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>

#include "kinds/entries.h"
#include "kinds/filter_taps.h"
#include "kinds/integrators.h"
#include "kinds/lights.h"
#include "kinds/materials.h"
#include "program/disabled.h"
#include "program/light_choice.h"
#include "scene/open_media.h"
#include "settings/sampling.h"

namespace strahl {
namespace {

struct Cause {
  std::string why;
  SourceLocation where;
};

/// Effects without which one is nothing.
const std::map<std::string, std::vector<std::string>>& needs() {
  static const std::map<std::string, std::vector<std::string>> all{
      {"PANE", {"MEDIA", "materials/thindielectric"}}, {"OPEN_MEDIA", {"MEDIA"}}, {"UNLIT_MEDIA", {"MEDIA"}}};
  return all;
}

bool does_need(const std::string& name, const std::string& other) {
  const auto found = needs().find(name);
  return found != needs().end() && std::count(found->second.begin(), found->second.end(), other) > 0;
}

struct Causes {
  std::set<std::string> left_out;
  std::map<std::string, Cause> first;       ///< That was found of each name.
  std::optional<std::string> light_choice;  ///< As the settings have it.
  std::string light_chooser = "uniform";    ///< The entry that is called for, if any is.
  bool background = false;                  ///< A light that rays find where they leave the scene.

  [[nodiscard]] bool allow(const std::string& name) const {
    const auto needed = needs().find(name);
    return !left_out.contains(name) &&
           (needed == needs().end() || std::all_of(needed->second.begin(), needed->second.end(),
                                                   [&](const std::string& other) { return allow(other); }));
  }
  [[nodiscard]] bool contains(const std::string& name) const { return first.contains(name); }
};

void call_for(Causes& causes, const std::string& name, const std::string& why, const SourceLocation& where) {
  if (causes.allow(name)) causes.first.try_emplace(name, Cause{why, where});
}

const Material& material_at(const Scene& scene, int index) {
  return scene.materials.at(static_cast<std::size_t>(index));
}

void call_for_attribute(Causes& causes, const Texture& texture) {
  if (std::holds_alternative<AttributeTexture>(texture.pattern))
    call_for(causes, "MESH_ATTRIBUTE", "a texture of type mesh_attribute", texture.where);
}

/// Whether the program has the texture (-1: none) of a light.
bool use_light_texture(const Scene& scene, int index, Causes& causes) {
  if (index < 0 || !causes.allow("LIGHT_TEXTURE")) return false;
  const Texture& texture = scene.textures.at(static_cast<std::size_t>(index));
  const std::string effect = "textures/" + texture_kind(texture);
  if (!causes.allow(effect)) return false;
  call_for(causes, effect, "a light with a texture of type " + texture_kind(texture), texture.where);
  call_for(causes, "LIGHT_TEXTURE", "a light with a texture", texture.where);
  call_for_attribute(causes, texture);
  return true;
}

void aov_causes(const Scene& scene, const AovList& aovs, Causes& causes) {
  if (!aovs.plain().empty()) call_for(causes, "AOV", "--aov", {});
  if (aovs.names_first_samples()) call_for(causes, "AOV", "integrator aov", scene.integrator.aovs_where);
  if (aovs.plain().contains(Aov::albedo)) call_for(causes, "ALBEDO", "--aov albedo", {});
  if (aovs.contains(Aov::albedo)) call_for(causes, "ALBEDO", "integrator aov, albedo", scene.integrator.aovs_where);
  if (aovs.contains(Aov::xyz_squared)) call_for(causes, "MOMENT", "integrator moment", scene.integrator.aovs_where);
}

void shape_causes(const Scene& scene, const RenderSettings& settings, Causes& causes) {
  const kinds::IntegratorFacts& integrator = kinds::integrator(scene.integrator.name);
  const bool lit = integrator.shows_emission;
  const bool reflects = integrator.is_lit();
  const bool reads_materials = reflects || settings.aovs.contains(Aov::albedo);
  // Normals interpolated over a mesh reach the picture through lighting, the normals picture and its AOV, and the
  // albedo's: they say which side of a material is seen.
  const bool shading =
      integrator.reads_shading || settings.aovs.contains(Aov::normal) || settings.aovs.contains(Aov::albedo);
  std::map<int, bool> used;  // Whether it reads texture coordinates, of each material that has been looked at.
  std::function<bool(int, const SourceLocation&)> use_material = [&](int index, const SourceLocation& where) {
    const auto [known, is_new] = used.try_emplace(index, false);
    if (!is_new) return known->second;
    const Material& material = material_at(scene, index);
    const MaterialFacts facts = material_facts(material);
    const SourceLocation& place = material.where.line > 0 ? material.where : where;
    if (facts.nested.empty()) call_for(causes, "materials/" + facts.kind, "material of type " + facts.kind, place);
    if (facts.nested.empty() && !causes.allow("materials/" + facts.kind))
      call_for(causes, "BLACK", "material of type " + facts.kind + ", which --disable leaves out", place);
    if (integrator.goes_through && std::holds_alternative<ThinDielectric>(material.bsdf))
      call_for(causes, "PANE", "material of type thindielectric, under integrator " + scene.integrator.name, place);
    for (const std::string& flag : facts.flags) call_for(causes, flag, "material of type " + facts.kind, place);
    if (facts.is_twosided) call_for(causes, "TWOSIDED", "a twosided material", place);
    if (integrator.follows == kinds::Follows::mirrors &&
        facts.has_lobe(lobes::LOBE_REFLECT | lobes::LOBE_TRANSMIT | lobes::LOBE_DELTA))
      call_for(causes, "BRANCHES", "a material that reflects and transmits", place);
    if (facts.has_along) call_for(causes, "TANGENT", "material of type " + facts.kind + " with a direction", place);
    bool reads_uv = facts.has_along && causes.allow("TANGENT");
    std::vector<MaterialSlot> slots = facts.slots;
    if (facts.opacity) {
      call_for(causes, "MASK", "a mask", place);
      slots.push_back(*facts.opacity);
    }
    if (facts.is_twosided && material.back >= 0 && use_material(material.back, where)) reads_uv = true;
    for (const int nested : facts.nested)
      if (use_material(nested, where)) reads_uv = true;
    for (const MaterialSlot& slot : slots) {
      if (slot.texture < 0) continue;
      const Texture& texture = scene.textures.at(static_cast<std::size_t>(slot.texture));
      const std::string pattern = texture_kind(texture);
      if (!causes.allow("textures/" + pattern)) continue;
      call_for(causes, "textures/" + pattern, "a reflectance from a texture of type " + pattern,
               texture.where.line > 0 ? texture.where : place);
      call_for_attribute(causes, texture);
      reads_uv = true;
    }
    return used[index] = reads_uv;
  };
  // Only the first cause of each is told: of a million spheres one is looked at.
  std::set<std::tuple<std::size_t, int, bool, bool, int>> seen;
  const auto look_at = [&](const Shape& shape) {
    const auto* mesh = std::get_if<Mesh>(&shape.geometry);
    if (!causes.allow("shapes/" + shape_kind(shape))) return;
    if (!mesh && !shape.priority &&
        !seen.emplace(shape.geometry.index(), shape.material, shape.radiance.has_value(), shape.exitance.has_value(),
                      shape.radiance_texture)
             .second)
      return;
    const std::string kind = shape_kind(shape);
    call_for(causes, "shapes/" + kind, "a shape made of " + kind + " primitives", shape.where);
    if (mesh && shading && !mesh->normals.empty())
      call_for(causes, "SMOOTH_NORMALS", "a mesh with vertex normals", shape.where);
    if (mesh && settings.aovs.contains(Aov::uv) && !mesh->uvs.empty())
      call_for(causes, "MESH_UVS",
               std::string("a mesh with texture coordinates, for ") +
                   (settings.aovs.plain().contains(Aov::uv) ? "--aov uv" : "integrator aov"),
               shape.where);
    auto emit = [&](const SourceLocation& where, const std::string& light) {
      const std::string area = area_kind(shape.geometry);
      if (!reflects || area.empty() || !causes.allow("areas/" + area) || !causes.allow("lights/" + light)) return;
      call_for(causes, "areas/" + area, "an area emitter on a " + kind, where);
      call_for(causes, "lights/" + light, "an area emitter", where);
    };
    bool reads_uv = false;
    if (lit && shape.radiance) {
      call_for(causes, "EMISSION", "an area emitter", shape.radiance_where);
      emit(shape.radiance_where, "area");
      if (use_light_texture(scene, shape.radiance_texture, causes)) reads_uv = true;
    }
    if (lit && shape.exitance && scene.integrator.hide_emitters)
      call_for(causes, "EMISSION", "a hidden emitter of type directionalarea", shape.radiance_where);
    if (integrator.from_lights && shape.exitance) {
      emit(shape.radiance_where, "directionalarea");
      if (use_light_texture(scene, shape.radiance_texture, causes)) reads_uv = true;
    }
    if (reflects && shape.priority) call_for(causes, "PRIORITY", "a shape with a priority", shape.where);
    if (reads_materials && !(mesh && !mesh->parts.empty()) && use_material(shape.material, shape.where))
      reads_uv = true;
    if (!mesh) return;
    for (const MeshPart& part : mesh->parts) {
      if (lit && part.radiance) {
        call_for(causes, "EMISSION", "a mesh material that emits", shape.where);
        emit(shape.where, "area");
        if (use_light_texture(scene, part.radiance_texture, causes)) reads_uv = true;
      }
      if (reads_materials && use_material(part.material, shape.where)) reads_uv = true;
    }
    if (reads_uv && !mesh->uvs.empty())
      call_for(causes, "MESH_UVS", "a mesh with texture coordinates, for its textures", shape.where);
  };
  for (const Shape& shape : scene.shapes) look_at(shape);
  if (!causes.allow("INSTANCES")) return;
  for (const Group& group : scene.groups)
    for (const Shape& shape : group.shapes) look_at(shape);
}

/// Media, where the integrator goes through them.
void media_causes(const Scene& scene, Causes& causes) {
  if (!kinds::integrator(scene.integrator.name).goes_through || !causes.allow("MEDIA")) return;
  const bool has_media = !scene.media.empty();
  const std::string why = has_media ? "a medium" : "integrator " + scene.integrator.name;
  const SourceLocation& where = has_media ? scene.media.front().where : scene.integrator.where;
  call_for(causes, "MEDIA", why, where);
  if (!has_media) call_for(causes, "media/homogeneous", why, where);
  for (const Medium& medium : scene.media)
    call_for(causes, "media/" + medium_entry(medium), "a medium of that type", medium.where);
  for (const Medium& medium : scene.media)
    if (!medium.samples_emitters)
      call_for(causes, "UNLIT_MEDIA", "a medium whose sample_emitters is false", medium.where);
  for (const Medium& medium : scene.media)
    for (const PhaseFunction& phase : medium.phases)
      call_for(causes, "phases/" + phase_entry(phase.kind), "a phase function of that type", medium.where);
  const auto is_drawn_afar = [&](const Light& light) {
    const kinds::LightFacts& facts = kinds::light(light);
    return facts.is_far && kinds::is_drawn(light, scene) && causes.contains(std::string("lights/") + facts.entry);
  };
  if (const std::optional<SourceLocation> open = open_medium(scene);
      open && std::any_of(scene.lights.begin(), scene.lights.end(), is_drawn_afar))
    call_for(causes, "OPEN_MEDIA", "a medium without an end, and an emitter infinitely far away", *open);
}

/// Does a sample draw more than its place in the pixel? Of a blend a material is drawn, of a mask whether light passes.
bool draws(const kinds::IntegratorFacts& integrator, const Causes& causes) {
  return integrator.follows == kinds::Follows::paths || integrator.asks_openness ||
         (integrator.is_lit() &&
          (causes.contains("EMISSION") || causes.background || causes.contains("BLEND") || causes.contains("MASK")));
}

/// Lights outside shapes, and what chooses among lights where any is drawn.
void light_causes(const Scene& scene, Causes& causes) {
  const kinds::IntegratorFacts& integrator = kinds::integrator(scene.integrator.name);
  const Cause* drawn = nullptr;
  const auto note = [&](const std::string& effect) {
    const auto found = causes.first.find(effect);
    if (found != causes.first.end() && drawn == nullptr) drawn = &found->second;
  };
  note("lights/area");
  note("lights/directionalarea");
  for (const Light& light : scene.lights) {
    const kinds::LightFacts& facts = kinds::light(light);
    if (!integrator.is_lit() && !(integrator.shows_emission && facts.is_background)) continue;
    if (facts.is_beam && !integrator.from_lights) continue;
    const std::string kind = facts.entry, effect = "lights/" + kind;
    call_for(causes, effect, "an emitter of type " + kind, light.where);
    causes.background = causes.background || (facts.is_background && causes.contains(effect));
    if (facts.is_sun && causes.contains(effect)) call_for(causes, "SUN", "an emitter of type sun", light.where);
    if (causes.contains(effect)) use_light_texture(scene, kinds::light_texture(light), causes);
    if (kinds::is_drawn(light, scene)) note(effect);
  }
  if (!integrator.is_lit() || drawn == nullptr) return;
  const DrawnLights lights = drawn_lights(scene, [&](const std::string& name) { return causes.contains(name); });
  if (lights.count == 0) return;
  causes.light_chooser = integrator.from_lights && lights.count > 1 ? "power" : light_chooser(lights);
  if (lights.count > 1 && causes.light_choice) causes.light_chooser = *causes.light_choice;
  call_for(causes, "choosers/" + causes.light_chooser,
           lights.count < 2 ? drawn->why : fmt::format("{} lights to draw from", lights.count), drawn->where);
}

Causes causes_of(const Scene& scene, const RenderSettings& settings) {
  require_chooser(settings.light_choice);
  Causes causes{disabled_effects(settings.disabled), {}, settings.light_choice};
  shape_causes(scene, settings, causes);
  if (!scene.instances.empty()) call_for(causes, "INSTANCES", "an instance of a group", scene.instances.front().where);
  light_causes(scene, causes);
  media_causes(scene, causes);
  const std::string& integrator = scene.integrator.name;
  const kinds::IntegratorFacts& facts = kinds::integrator(integrator);
  if (scene.integrator.hide_emitters && (causes.contains("EMISSION") || causes.background))
    call_for(causes, "HIDE_EMITTERS", "the integrator's hide_emitters", scene.integrator.where);
  if (scene.integrator.strict_normals && facts.is_lit() && causes.contains("SMOOTH_NORMALS"))
    call_for(causes, "STRICT_NORMALS", "the integrator's strict_normals", scene.integrator.where);
  const std::string& why = scene.integrator.why;
  call_for(causes, "integrators/" + integrator, why.empty() ? "integrator " + integrator : "integrator auto: " + why,
           scene.integrator.where);
  // Whatever the number of samples, which must not change the program; a filter of width 0 serves the centre by
  // default.
  const bool is_spread = scene.sampler.kind != SamplerKind::centre;
  if (is_spread) call_for(causes, "PIXEL_FILTER", "samples anywhere but at the pixels' centres", scene.sampler.where);
  if (is_spread && !facts.from_lights && kinds::filter_taps(scene.film.filter).reach > 0)
    call_for(causes, "SHARED_SAMPLES", "a pixel filter that is wider than a pixel", scene.film.where);
  if (is_spread && scene.camera.aperture_radius > 0)
    call_for(causes, "THIN_LENS", "a sensor of type thinlens", scene.camera.where);
  const bool draws_blends = settings.aovs.contains(Aov::albedo) && causes.contains("BLEND");
  if (is_spread || draws_blends || draws(facts, causes)) {
    const std::string sampler = sampler_entry(resolve_sampling(scene).kind);
    call_for(causes, "samplers/" + sampler, "numbers that samples draw", scene.sampler.where);
  }
  if (facts.from_lights) call_for(causes, "LIGHT_PATHS", "integrator " + integrator, scene.integrator.where);
  if (facts.asks_openness) call_for(causes, "OPENNESS", "integrator ao", scene.integrator.where);
  if (settings.texture_lod && causes.contains("textures/bitmap"))
    call_for(causes, "TEXTURE_LOD", "--texture-lod, and a bitmap", {});
  aov_causes(scene, settings.aovs, causes);
  if (settings.estimate_error) call_for(causes, "ERROR_SUMS", "the estimate of the picture's error", {});
  if (settings.count_rays) call_for(causes, "COUNT_RAYS", "--stats-detail", {});
  if (settings.loop_turns) call_for(causes, "LOOP_LIMIT", "a device that ends long loops", {});
  return causes;
}

/// The integrator of the scene that calls for the effect where its values can be written; empty: none.
std::string asking_scene(const Scene& scene, const std::string& name) {
  for (const NamedAov& named : scene.integrator.aovs) {
    if (name == "AOV" && is_of_first_sample(named.aov)) return "integrator aov";
    if (name == "MOMENT" && named.aov == Aov::xyz_squared) return "integrator moment";
  }
  return {};
}

/// Could a program of this integrator's kernel use it? Even --generic leaves the rest out.
bool has_place(const kinds::IntegratorFacts& integrator, const std::string& name) {
  if (integrator.from_lights ? name == "MEDIA" || does_need(name, "MEDIA") : name == "LIGHT_PATHS") return false;
  const std::vector<std::string>& entries = kinds::integrator_names();
  return std::none_of(entries.begin(), entries.end(), [&](const std::string& entry) {
    const kinds::IntegratorFacts& other = kinds::integrator(entry);
    return other.from_lights && other.kernel() != std::string_view(integrator.kernel()) &&
           name == "integrators/" + entry;
  });
}

}  // namespace

bool Features::has(const std::string& list, const std::string& entry) const {
  const auto found = entries.find(list);
  return found != entries.end() && found->second.contains(entry);
}

bool Features::flag(const std::string& name) const {
  const auto found = std::find_if(flags.begin(), flags.end(), [&](const auto& flag) { return flag.first == name; });
  if (found == flags.end()) throw std::logic_error("features.def has no " + name);
  return found->second;
}

int Features::entry_index(const std::string& list, const std::string& entry) const {
  int index = 0;
  for (const std::string& name : list_entries(list)) {
    if (name == entry) return has(list, entry) ? index : -1;
    if (has(list, name)) ++index;
  }
  throw std::logic_error(list + " has no entry " + entry);
}

Features no_features(bool ends_loops) {
  Features features;
  for (const std::string& list : list_folders()) features.entries[list];
  for (const auto& [flag, why] : list_features()) features.flags.emplace_back(flag, ends_loops && flag == "LOOP_LIMIT");
  return features;
}

Features features_of(const Scene& scene, const RenderSettings& settings) {
  const Causes causes = causes_of(scene, settings);
  Features features;
  auto report = [&](const std::string& name, const std::string& purpose) {
    const auto cause = causes.first.find(name);
    FeatureReport row{name, cause != causes.first.end(), purpose, {}};
    if (!causes.allow(name)) {
      row.why = "--disable";
    } else if (row.on) {
      row.why = cause->second.why;
      row.where = cause->second.where;
    } else if (settings.generic && name != "COUNT_RAYS" && name != "LOOP_LIMIT" && name != "TEXTURE_LOD" &&
               name != "MOMENT" && name != "SHARED_SAMPLES" &&
               has_place(kinds::integrator(scene.integrator.name), name)) {
      row.on = true;
      row.why = "--generic";
    } else if (const std::string asking = asking_scene(scene, name); !asking.empty()) {
      row.why = asking + " calls for it where an .exr is written";
      row.where = scene.integrator.aovs_where;
    }
    features.report.push_back(row);
    return row.on;
  };
  for (const std::string& list : list_folders()) {
    auto& active = features.entries[list];
    for (const std::string& entry : list_entries(list))
      if (report(list + "/" + entry, {})) active.insert(entry);
  }
  features.light_chooser = causes.light_chooser;
  features.is_generic = settings.generic;
  for (const auto& [name, purpose] : list_features()) features.flags.emplace_back(name, report(name, purpose));
  return features;
}

}  // namespace strahl
