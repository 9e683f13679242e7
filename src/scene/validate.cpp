// SPDX-License-Identifier: MIT
// Invariants of a scene beside those of its shapes' geometry (validate_geometry.cpp).
#include "scene/validate.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "did_you_mean.h"
#include "kinds/entries.h"
#include "kinds/integrators.h"
#include "kinds/lights.h"
#include "kinds/lobes_inside.h"
#include "kinds/materials.h"
#include "kinds/reflectance.h"
#include "kinds/textures.h"
#include "scene/model/transforms.h"
#include "scene/validate_geometry.h"

namespace strahl {

namespace {

class Checker {
 public:
  explicit Checker(std::vector<Diagnostic>& found) : found_(found) {}
  /// What is checked from here on; it must stay where it is.
  void at(const SourceLocation& where) { where_ = &where; }
  /// The message is only made where it is needed: there may be millions of shapes.
  template <typename... Values>
  void require(bool holds, fmt::format_string<Values...> message, Values&&... values) {
    if (!holds) found_.push_back({Severity::error, *where_, fmt::format(message, std::forward<Values>(values)...)});
  }
  void require_light(const Rgb& c, const char* what) {
    require(std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b) && c.r >= 0 && c.g >= 0 && c.b >= 0,
            "the {} must be finite and not negative", what);
    // What the film and a picture's floats hold, in every tier.
    constexpr double most = std::numeric_limits<float>::max();
    const double largest = std::max({c.r, c.g, c.b});
    require(!std::isfinite(largest) || largest <= most, "the {} must be at most {:.3g}, the largest float", what, most);
  }

 private:
  std::vector<Diagnostic>& found_;
  const SourceLocation* where_ = nullptr;
};

bool is_index(int index, std::size_t size) { return index >= 0 && static_cast<std::size_t>(index) < size; }

/// -1: none.
void check_light_texture(int texture, const Scene& scene, Checker& check) {
  check.require(texture == -1 || is_index(texture, scene.textures.size()), "texture {} does not exist; there are {}",
                texture, scene.textures.size());
}

void check_medium(const Medium& medium, Checker& check) {
  check.at(medium.where);
  check.require_light(medium.sigma_t.largest(), "sigma_t of a medium");
  check.require_light(medium.emission.largest(), "emission of a medium");
  for (const Volume* volume : {&medium.sigma_t, &medium.albedo, &medium.emission}) {
    check.require(!volume->grid || medium.is_heterogeneous(), "a medium with a grid has one of its sigma_t");
    const Transform& placed = volume->world_from_cube;
    check.require(!volume->grid || (placed.is_finite() && !is_singular(placed)),
                  "where a volume lies, by its to_world and the box of its grid, must be finite and not singular");
  }
  const Rgb a = medium.albedo.largest();
  const auto is_share = [](double x) { return x >= 0 && x <= 1; };
  check.require(is_share(a.r) && is_share(a.g) && is_share(a.b), "the albedo of a medium must lie within [0, 1]");
  double sum = 0;
  for (const PhaseFunction& phase : medium.phases) {
    check.require(std::abs(phase.g) < 1, "g of a phase function must lie within (-1, 1)");
    check.require(phase.share >= 0, "the share of a phase function must not be negative");
    sum += phase.share;
  }
  check.require(std::abs(sum - 1) < 1e-6, "the shares of a medium's phase functions must add up to 1");
}

/// -1: none.
void check_medium_index(int medium, const Scene& scene, Checker& check) {
  check.require(medium == -1 || is_index(medium, scene.media.size()), "medium {} does not exist; there are {}", medium,
                scene.media.size());
}

void check_sampling_weight(double weight, Checker& check) {
  check.require(std::isfinite(weight) && weight >= 0, "sampling_weight must be finite and at least 0, not {}", weight);
}

void check_shape(const Shape& shape, const Scene& scene, Checker& check, std::vector<Diagnostic>& found) {
  check.at(shape.where);
  check.require(is_index(shape.material, scene.materials.size()), "material {} does not exist; there are {}",
                shape.material, scene.materials.size());
  if (shape.media) {
    check_medium_index(shape.media->inside, scene, check);
    check_medium_index(shape.media->outside, scene, check);
  }
  check_sampling_weight(shape.sampling_weight, check);
  for (const std::string& fault : geometry_faults(shape.geometry))
    found.push_back({Severity::error, shape.where, fault});
  if (const Mesh* mesh = std::get_if<Mesh>(&shape.geometry)) {
    for (const MeshPart& part : mesh->parts) {
      check.require(is_index(part.material, scene.materials.size()), "material {} of a mesh part does not exist",
                    part.material);
      if (part.radiance) check.require_light(*part.radiance, "radiance of a mesh part");
      check_light_texture(part.radiance_texture, scene, check);
    }
  }
  if (!shape.radiance && !shape.exitance) return;
  if (!shape.radiance_where.file.empty()) check.at(shape.radiance_where);
  check.require_light(shape.radiance.value_or(Rgb{}), "radiance");
  check.require_light(shape.exitance.value_or(Rgb{}), "radiance");
  check_light_texture(shape.radiance_texture, scene, check);
}

/// Textures that a material reads, inside it and from behind too.
std::set<int> textures_of(const Scene& scene, int index) {
  std::set<int> textures;
  if (!is_index(index, scene.materials.size())) return textures;
  const auto add = [&](const Material& material) {
    const MaterialFacts facts = material_facts(material);
    for (const MaterialSlot& slot : facts.slots) textures.insert(slot.texture);
    if (facts.opacity) textures.insert(facts.opacity->texture);
  };
  const Material& material = scene.materials[static_cast<std::size_t>(index)];
  add(material);
  for (const int inside : materials_inside(scene, material, true))
    add(scene.materials[static_cast<std::size_t>(inside)]);
  return textures;
}

/// Attributes that a shape must have. Known of its material are those that were asked for before.
void check_attributes(const Shape& shape, const Scene& scene, std::map<int, std::set<int>>& known, Checker& check) {
  const auto [found, is_new] = known.try_emplace(shape.material);
  if (is_new) found->second = textures_of(scene, shape.material);
  std::set<int> textures = found->second;
  if (shape.radiance || shape.exitance) textures.insert(shape.radiance_texture);
  for (const int index : textures) {
    if (!is_index(index, scene.textures.size())) continue;
    const auto* texture = std::get_if<AttributeTexture>(&scene.textures[static_cast<std::size_t>(index)].pattern);
    if (texture == nullptr) continue;
    const auto* mesh = std::get_if<Mesh>(&shape.geometry);
    const bool has_it = mesh != nullptr && std::any_of(mesh->attributes.begin(), mesh->attributes.end(),
                                                       [&](const auto& one) { return one.name == texture->name; });
    check.at(shape.where);
    check.require(has_it, "the shape has no attribute \"{}\", which a texture of its shows", texture->name);
  }
}

void check_group(const Group& group, const Scene& scene, Checker& check, std::vector<Diagnostic>& found) {
  check.at(group.where);
  check.require(!group.shapes.empty(), "the group has no shapes");
  for (const Shape& shape : group.shapes) {
    check_shape(shape, scene, check, found);
    check.at(shape.where);
    check.require(!area_kind(shape.geometry).empty(),
                  "an infinite plane cannot be part of a shapegroup; use a rectangle, or place it outside");
    const Mesh* mesh = std::get_if<Mesh>(&shape.geometry);
    const auto emits = [](const MeshPart& part) { return part.radiance.has_value(); };
    check.require(mesh == nullptr || std::none_of(mesh->parts.begin(), mesh->parts.end(), emits),
                  "a mesh whose materials emit (Ke) cannot be part of a shapegroup; place it outside");
    if (!shape.radiance_where.file.empty()) check.at(shape.radiance_where);
    check.require(!shape.radiance && !shape.exitance,
                  "an emitter cannot be part of a shapegroup; place the shape outside");
  }
}

void check_instance(const Instance& instance, const Scene& scene, Checker& check) {
  check.at(instance.where);
  check.require(is_index(instance.group, scene.groups.size()), "group {} does not exist; there are {}", instance.group,
                scene.groups.size());
  check.require(instance.world_from_group.is_finite() && !is_singular(instance.world_from_group),
                "the instance's transform must be finite and not singular");
}

/// Readers of a scene walk from a material to its back, and on to the back of that.
bool backs_end(const Material& material, const Scene& scene) {
  int back = material.back;
  for (int walked = 0; is_index(back, scene.materials.size()); ++walked) {
    if (walked == deepest_material) return false;
    back = scene.materials[static_cast<std::size_t>(back)].back;
  }
  return true;
}

void check_material(const Material& material, const Scene& scene, Checker& check) {
  check.at(material.where);
  const MaterialFacts facts = material_facts(material);
  std::vector<MaterialSlot> slots = facts.slots;
  if (facts.opacity) slots.push_back(*facts.opacity);
  check.require(material.back == -1 || is_index(material.back, scene.materials.size()),
                "material {} of its back does not exist; there are {}", material.back, scene.materials.size());
  check.require(backs_end(material, scene),
                "the backs of backs must come to an end within {} materials; -1 is what looks alike from both sides",
                deepest_material);
  for (const MaterialSlot& slot : slots) {
    const auto& [r, g, b] = slot.reals;
    check.require(!slot.is_share || is_reflectance({r, g, b}), "{} must lie in [0, 1]", slot.name);
    check.require(slot.texture == -1 || is_index(slot.texture, scene.textures.size()),
                  "texture {} does not exist; there are {}", slot.texture, scene.textures.size());
    check.require(!slot.is_share || !is_index(slot.texture, scene.textures.size()) ||
                      !scene.textures[static_cast<std::size_t>(slot.texture)].is_unbounded,
                  "texture {} is no share of light, as {} is", slot.texture, slot.name);
  }
  for (const std::string& fault : facts.faults) check.require(false, "{}", fault);
}

void check_nested(const Scene& scene, Checker& check) {
  bool are_before = true, are_deep = false;
  std::vector<int> depths(scene.materials.size(), 1);
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    check.at(scene.materials[i].where);
    for (const int nested : material_facts(scene.materials[i]).nested) {
      are_before = are_before && is_index(nested, i);
      check.require(is_index(nested, i), "materials inside another must stand before it; {} does not", nested);
      if (is_index(nested, i)) depths[i] = std::max(depths[i], depths[static_cast<std::size_t>(nested)] + 1);
    }
    // One of a chain is named.
    check.require(depths[i] != deepest_material + 1, "materials are nested deeper than {}", deepest_material);
    are_deep = are_deep || depths[i] > deepest_material;
  }
  if (!are_before || are_deep) return;
  LobesInside lobes;
  for (const Material& material : scene.materials) {
    check.at(material.where);
    check.require(!material_facts(material).is_coat || !lobes.transmits(scene, material),
                  "what lies under a coating must not let light through");
    const bool has_nested = !material_facts(material).nested.empty();
    check.require(!has_nested || !material.twosided || !lobes.transmits(scene, material),
                  "what is twosided must not let light through");
  }
}

void check_texture(const Texture& texture, Checker& check) {
  check.at(texture.where);
  for (const std::string& fault : kinds::texture(texture).faults) check.require(false, "{}", fault);
}

void check_light(const Light& light, const Scene& scene, Checker& check) {
  check.at(light.where);
  const int texture = kinds::light_texture(light);
  check_light_texture(texture, scene, check);
  check.require(
      !is_index(texture, scene.textures.size()) ||
          !std::holds_alternative<AttributeTexture>(scene.textures[static_cast<std::size_t>(texture)].pattern),
      "a light without a mesh has no mesh_attribute");
  check_sampling_weight(light.sampling_weight, check);
  for (const std::string& fault : kinds::light_faults(light)) check.require(false, "{}", fault);
}

void check_camera(const Camera& camera, Checker& check) {
  check.at(camera.where);
  const Transform& t = camera.world_from_camera;
  check.require(t.is_finite() && !is_singular(t), "the camera's transform must be finite and not singular");
  check.require(camera.fov_degrees > 0 && camera.fov_degrees < 180, "fov must lie between 0 and 180 degrees");
  check.require(std::isfinite(camera.principal_point_offset_x) && std::isfinite(camera.principal_point_offset_y),
                "the principal point offset must be finite");
  check.require(std::isfinite(camera.aperture_radius) && camera.aperture_radius >= 0,
                "aperture_radius must be finite and not negative");
  check.require(std::isfinite(camera.focus_distance) && camera.focus_distance > 0,
                "focus_distance must be finite and greater than 0");
  check.require(camera.aperture_radius == 0 || camera.projection == Projection::perspective,
                "only a perspective camera has a lens");
  check.require(camera.near_clip >= 0 && camera.far_clip > camera.near_clip, "0 <= near_clip < far_clip must hold");
}

void check_film(const Film& film, Checker& check) {
  check.at(film.where);
  const auto is_size = [](int size) { return size >= 1 && size <= Film::largest_size; };
  check.require(is_size(film.width) && is_size(film.height), "the film is {} x {}; sizes lie in [1, {}]", film.width,
                film.height, Film::largest_size);
  const Window w = film.window();
  check.require(w.x0 >= 0 && w.y0 >= 0 && w.x0 < w.x1 && w.y0 < w.y1 && w.x1 <= film.width && w.y1 <= film.height,
                "the crop window must hold a pixel and lie inside the picture");
  check.require(std::isfinite(film.filter.radius) && film.filter.radius >= 0,
                "the filter's radius must not be negative");
  check.require(std::isfinite(film.filter.stddev) && film.filter.stddev > 0,
                "the filter's stddev must be greater than 0");
  check.require(film.filter.radius <= Filter::largest_radius,
                "the filter's radius is {} pixels; at most {} are possible", film.filter.radius,
                Filter::largest_radius);
  check.require(film.filter.kind != FilterKind::gaussian || film.filter.radius > 0 ||
                    film.filter.stddev <= Filter::largest_radius / 4,
                "the filter's stddev is {} pixels; at most {} are possible", film.filter.stddev,
                Filter::largest_radius / 4);
  check.require(
      std::fabs(film.filter.b) <= Filter::largest_of_cubic && std::fabs(film.filter.c) <= Filter::largest_of_cubic,
      "the filter's B and C must lie within -{0} and {0}", Filter::largest_of_cubic);
  check.require(film.filter.kind != FilterKind::lanczos || film.filter.radius <= Filter::most_lobes,
                "the filter has {} lobes; at most {} are possible", film.filter.radius, Filter::most_lobes);
}

void check_integrator_name(const std::string& name, Checker& check) {
  const std::vector<std::string>& known = kinds::integrator_names();
  check.require(!name.empty(), "the integrator has no name");
  check.require(name.empty() || std::find(known.begin(), known.end(), name) != known.end(),
                "there is no integrator \"{}\"{}; there are: {}", name, did_you_mean(name, known),
                fmt::join(known, ", "));
}

}  // namespace

std::vector<Diagnostic> validate_picture(const Scene& scene) {
  std::vector<Diagnostic> found;
  Checker check(found);
  check_camera(scene.camera, check);
  check_film(scene.film, check);
  check.at(scene.sampler.where);
  check.require(scene.sampler.sample_count.value_or(1) >= 1, "sample_count must be at least 1");
  check.require(scene.sampler.seed.value_or(0) >= 0, "seed must be at least 0");
  check.at(scene.integrator.where);
  check_integrator_name(scene.integrator.name, check);
  check.require(scene.integrator.max_depth >= -1, "max_depth must be -1 (no limit) or more");
  check.require(scene.integrator.max_distance > 0, "max_distance must be greater than 0");
  check.require(scene.integrator.rr_depth >= 1, "rr_depth must be at least 1");
  check.at(scene.integrator.aovs_where);
  for (const std::string& fault : aov_faults(scene.integrator.aovs)) check.require(false, "{}", fault);
  return found;
}

std::vector<Diagnostic> validate(const Scene& scene) {
  std::vector<Diagnostic> found;
  Checker check(found);
  const bool has_attributes = std::any_of(scene.textures.begin(), scene.textures.end(), [](const Texture& texture) {
    return std::holds_alternative<AttributeTexture>(texture.pattern);
  });
  std::map<int, std::set<int>> known;
  if (has_attributes) for_each_shape(scene, [&](const Shape& shape) { check_attributes(shape, scene, known, check); });
  for (const Shape& shape : scene.shapes) check_shape(shape, scene, check, found);
  for (const Group& group : scene.groups) check_group(group, scene, check, found);
  for (const Instance& instance : scene.instances) check_instance(instance, scene, check);
  const SourceLocation nowhere;
  check.at(nowhere);
  check.require(!scene.materials.empty(), "materials[0], the default, is missing");
  for (const Material& material : scene.materials) check_material(material, scene, check);
  check_nested(scene, check);
  for (const Texture& texture : scene.textures) check_texture(texture, check);
  int backgrounds = 0, suns = 0;
  for (const Light& light : scene.lights) {
    check_light(light, scene, check);
    const bool is_sun = kinds::light(light).is_sun, is_background = kinds::light(light).is_background && !is_sun;
    backgrounds += is_background ? 1 : 0;
    suns += is_sun ? 1 : 0;
    check.require(backgrounds <= 1 || !is_background, "a scene has one constant, envmap or sky emitter at most");
    check.require(suns <= 1 || !is_sun, "a scene has one sun at most");
  }
  for (const Medium& medium : scene.media) check_medium(medium, check);
  check.at(scene.camera.where);
  check_medium_index(scene.camera.medium, scene, check);
  const std::vector<Diagnostic> of_picture = validate_picture(scene);
  found.insert(found.end(), of_picture.begin(), of_picture.end());
  return found;
}

}  // namespace strahl
