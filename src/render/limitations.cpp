// SPDX-License-Identifier: MIT
#include "render/limitations.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <variant>

#include "kinds/entries.h"
#include "kinds/filter_density.h"
#include "kinds/integrators.h"
#include "kinds/lights.h"
#include "kinds/materials.h"
#include "kinds/shapes.h"
#include "kinds/textures.h"
#include "packing/pack_areas.h"
#include "scene/beams.h"
#include "scene/light_path_fault.h"
#include "scene/open_media.h"
#include "settings/sampling.h"

namespace strahl {

namespace {

bool emits(const Shape& shape) {
  bool any = shape.radiance.has_value();
  if (const auto* mesh = std::get_if<Mesh>(&shape.geometry))
    for (const MeshPart& part : mesh->parts) any = any || part.radiance;
  return any;
}

/// Emission shows emitters; lights of a single direction are invisible.
bool emits_light(const Light& light, bool must_be_seen) {
  return must_be_seen ? kinds::light_glows(light) : kinds::gives_light(light);
}

/// Of what it absorbs.
bool emits_light(const Medium& medium) {
  return kinds::gives_light(kinds::times(medium.emission.largest(), medium.sigma_t.largest()));
}

/// Light, or what it emits itself.
bool shows_light(const Medium& medium) {
  return emits_light(medium) || kinds::gives_light(kinds::times(medium.albedo.largest(), medium.sigma_t.largest()));
}

/// Whether rays from the camera find anything where there is no shape: what shines behind all else, or the medium that
/// the camera is within.
bool shows_without_shapes(const Scene& scene, const kinds::IntegratorFacts& integrator) {
  if (integrator.goes_through && scene.camera.medium >= 0) {
    const Medium& medium = scene.media.at(static_cast<std::size_t>(scene.camera.medium));
    if (shows_light(medium)) return true;
    if (open_medium(scene)) return false;  // The sky is behind all of it.
  }
  return integrator.shows_emission && !scene.integrator.hide_emitters &&
         std::any_of(scene.lights.begin(), scene.lights.end(),
                     [](const Light& light) { return kinds::light_glows(light); });
}

/// Why the picture will be empty; none where it will not.
std::optional<std::string> emptiness(const Scene& scene) {
  const kinds::IntegratorFacts& integrator = kinds::integrator(scene.integrator.name);
  if (scene.shapes.empty() && scene.instances.empty() && !shows_without_shapes(scene, integrator))
    return "the scene has no shape: no ray hits anything; add a <shape>";
  if (!integrator.shows_emission) return std::nullopt;
  if (has_beams_alone(scene) && integrator.is_lit()) return std::nullopt;
  const bool must_be_seen = !integrator.is_lit();
  const auto shape_emits = [](const Shape& shape) { return kinds::gives_light(shape); };
  const auto medium_emits = [](const Medium& medium) { return emits_light(medium); };
  if (integrator.goes_through && std::any_of(scene.media.begin(), scene.media.end(), medium_emits)) return std::nullopt;
  const auto light_emits = [&](const Light& light) { return emits_light(light, must_be_seen); };
  if (std::any_of(scene.shapes.begin(), scene.shapes.end(), shape_emits) ||
      std::any_of(scene.lights.begin(), scene.lights.end(), light_emits) || scene.lost_emitters > 0)
    return std::nullopt;
  return fmt::format(
      "nothing in the scene emits light{}: integrator {} makes a black picture; add an <emitter>, or see "
      "the shapes with --integrator normals or ao",
      must_be_seen ? " that is seen" : "", scene.integrator.name);
}

/// Emitters of sampling_weight 0 whose light whitted shows to the camera alone: it draws places on emitters and no
/// directions.
std::vector<SourceLocation> undrawn_and_seen(const Scene& scene) {
  std::vector<SourceLocation> seen;
  if (kinds::integrator(scene.integrator.name).follows != kinds::Follows::mirrors) return seen;
  for (const Light& light : scene.lights)
    if (light.sampling_weight == 0 && kinds::light_glows(light)) seen.push_back(light.where);
  for (const Shape& shape : scene.shapes)
    if (shape.sampling_weight == 0 && kinds::gives_light(shape) && !area_kind(shape.geometry).empty())
      seen.push_back(shape.radiance_where);
  return seen;
}

/// Those of the scene's shapes, behind others too, that reflect and transmit nothing but along single directions.
std::set<int> mirrors_of(const Scene& scene) {
  std::set<int> on_shapes;
  const auto add = [&](int material) {
    for (; material >= 0 && on_shapes.insert(material).second;)
      material = scene.materials[static_cast<std::size_t>(material)].back;
  };
  for_each_shape(scene, [&](const Shape& shape) {
    const auto* mesh = std::get_if<Mesh>(&shape.geometry);
    if (mesh == nullptr || mesh->parts.empty()) return add(shape.material);
    for (const MeshPart& part : mesh->parts) add(part.material);
  });
  std::erase_if(on_shapes, [&](int material) {
    const int lobes = lobes_of(scene, scene.materials[static_cast<std::size_t>(material)]);
    return (lobes & lobes::LOBE_DELTA) == 0 || (lobes & (lobes::LOBE_DIFFUSE | lobes::LOBE_GLOSSY)) != 0;
  });
  return on_shapes;
}

/// Emitters of sampling_weight 0 that no ray from the camera finds either.
std::vector<SourceLocation> undrawn_and_unhit(const Scene& scene) {
  const kinds::IntegratorFacts& integrator = kinds::integrator(scene.integrator.name);
  const bool finds_emitters = !integrator.from_lights || integrator.from_camera;
  std::vector<SourceLocation> lost;
  if (integrator.lamps != kinds::Lamps::drawn) return lost;
  for (const Light& light : scene.lights)
    if (light.sampling_weight == 0 && kinds::gives_light(light) && (kinds::light(light).is_delta || !finds_emitters))
      lost.push_back(light.where);
  for (const Shape& shape : scene.shapes)
    if (shape.sampling_weight == 0 && integrator.from_lights &&
        (shape.exitance || (kinds::gives_light(shape) && !finds_emitters)))
      lost.push_back(shape.radiance_where);
  return lost;
}

/// What finds the light of beams in this scene.
const char* finder_of_beams(const Scene& scene) {
  if (!light_path_fault(scene, "bdpt")) return "ptracer and bdpt do";
  if (!light_path_fault(scene, "ptracer")) return "ptracer does";
  return scene.media.empty() ? "ptracer and bdpt do where every shape is finite"
                             : "ptracer and bdpt do where there are no media";
}

/// What draws the places of samples from the pixel filter; empty: samples count in every pixel that it reaches.
std::string what_draws_from_filter(const Scene& scene, const std::set<std::string>& disabled) {
  if (kinds::integrator(scene.integrator.name).from_lights) return fmt::format("integrator {}", scene.integrator.name);
  const bool is_spread = resolve_sampling(scene).kind != SamplerKind::centre && !disabled.contains("PIXEL_FILTER");
  if (is_spread && disabled.contains("SHARED_SAMPLES")) return "a program without SHARED_SAMPLES";
  return {};
}

}  // namespace

std::vector<Diagnostic> limitations(const Scene& scene, const std::set<std::string>& disabled) {
  std::vector<Diagnostic> warnings;
  if (const std::optional<std::string> why = emptiness(scene))
    warnings.push_back(
        {Severity::warning, scene.integrator.where.file.empty() ? scene.camera.where : scene.integrator.where, *why});
  const auto warn = [&](const SourceLocation& where, std::string message) {
    warnings.push_back({Severity::warning, where, std::move(message)});
  };
  for (const SourceLocation& lost : undrawn_and_unhit(scene))
    warn(lost, fmt::format("this emitter's light is left out: its sampling_weight is 0, so that integrator {} never "
                           "draws it, and no ray hits it; give it a weight above 0",
                           scene.integrator.name));
  if (kinds::integrator(scene.integrator.name).from_lights && !kinds::integrator(scene.integrator.name).from_camera)
    for (const Material& material : scene.materials)
      if (material_facts(material).has_lobe(lobes::LOBE_DELTA))
        warn(material.where,
             fmt::format(
                 "what this material mirrors, or lets through unbent, is left out where the camera looks at it: "
                 "integrator {} joins surfaces with the camera, which mirrors and glass do not allow; {}",
                 scene.integrator.name, light_path_fault(scene, "bdpt") ? "path shows it" : "path and bdpt show it"));
  const std::string drawer = what_draws_from_filter(scene, disabled);
  if (!drawer.empty() && !kinds::is_density(scene.film.filter))
    warn(scene.film.where,
         "the pixel filter has negative parts, from which " + drawer + " cannot draw; a gaussian takes its place");
  if (kinds::integrator(scene.integrator.name).is_lit() && !kinds::integrator(scene.integrator.name).from_lights)
    for (const SourceLocation& beam : beams_of(scene))
      warn(beam, fmt::format("this emitter's light is left out: each of its places shines in one direction, so that "
                             "integrator {} cannot find it; {}",
                             scene.integrator.name, finder_of_beams(scene)));
  const kinds::Follows follows = kinds::integrator(scene.integrator.name).follows;
  const bool is_direct = follows == kinds::Follows::one_way, is_whitted = follows == kinds::Follows::mirrors;
  if (!(is_direct || is_whitted) || (scene.integrator.max_depth >= 0 && scene.integrator.max_depth < 2))
    return warnings;
  // Of two surfaces on a path no mirror shows the other.
  if (is_direct && scene.integrator.max_depth != 2)
    for (const int material : mirrors_of(scene))
      warn(scene.materials[static_cast<std::size_t>(material)].where,
           "this material shows emitters alone: integrator direct does not follow mirrors and glass, whitted does");
  for (const SourceLocation& seen : undrawn_and_seen(scene))
    warn(seen,
         "this emitter is seen but does not light the scene: its sampling_weight is 0, so that integrator whitted "
         "never draws it; give it a weight above 0, or take direct or path, which find it");
  for (const Shape& shape : scene.shapes)
    if (emits(shape) && is_whitted && area_kind(shape.geometry).empty())
      warn(shape.radiance_where.line > 0 ? shape.radiance_where : shape.where,
           "this area emitter is seen but does not light the scene: its area is infinite, so that integrator whitted "
           "cannot draw places on it; direct and path find it");
  return warnings;
}

std::optional<Diagnostic> too_wide_for_single(const Scene& scene) {
  const UploadFrame frame = camera_frame(scene);
  const Shape* farthest = nullptr;
  double reach = 0, smallest = std::numeric_limits<double>::infinity();
  for (const Shape& shape : scene.shapes) {
    const std::optional<Box> box = bounds(shape);
    if (!box) continue;
    const double far = std::max(largest_component(box->min - frame.origin), largest_component(box->max - frame.origin));
    if (far > reach) farthest = &shape;
    reach = std::max(reach, far);
    const double side = largest_component(box->max - box->min);
    if (side > 0) smallest = std::min(smallest, side);
  }
  // Products of three lengths, 2^-126, are the smallest normal numbers.
  if (farthest == nullptr || smallest * frame.scale >= 0x1p-42) return std::nullopt;
  return Diagnostic{Severity::warning, farthest->where,
                    fmt::format("this shape reaches to {:.2g} and another one is as small as {:.2g}: single precision "
                                "does not hold both, and the picture may lack light; bring this one nearer, or take "
                                "--precision double",
                                reach, smallest)};
}

namespace {

/// How far away it begins; 0: the place is within.
double distance_to(const Box& box, const Vec3& place) {
  const Vec3 before = box.min - place, behind = place - box.max;
  return std::max({0.0, before.x, before.y, before.z, behind.x, behind.y, behind.z});
}

/// Of light within the medium that the shape is full of; none: there is no such medium.
std::optional<double> free_path_within(const Scene& scene, const Shape& shape) {
  if (!shape.media || shape.media->inside < 0) return std::nullopt;
  const Rgb dense = scene.media.at(static_cast<std::size_t>(shape.media->inside)).sigma_t.largest();
  return 1 / std::max({dense.r, dense.g, dense.b});
}

}  // namespace

std::optional<Diagnostic> too_dense_for_single(const Scene& scene, const Vec3& origin) {
  if (!kinds::integrator(scene.integrator.name).goes_through) return std::nullopt;
  // Of a ball 1,000 units away whose mean free path is 6.5 steps, a twentieth of the light is lost; at 65 none is.
  constexpr double least_steps = 50;
  const auto warning = [&](const Shape& shape, double free_path, const Box& box) -> std::optional<Diagnostic> {
    const double distance = distance_to(box, origin), step = 0x1p-24 * distance;
    if (free_path >= least_steps * step) return std::nullopt;
    return Diagnostic{
        Severity::warning, shape.where,
        fmt::format("light goes {:.2g} on average within this body's medium, and single precision tells "
                    "its places {:.2g} apart, {:.2g} away: light is lost; bring it nearer, or take --precision double",
                    free_path, step, distance)};
  };
  for (const Shape& shape : scene.shapes)
    if (const auto free_path = free_path_within(scene, shape))
      if (const std::optional<Box> box = bounds(shape))
        if (auto found = warning(shape, *free_path, *box)) return found;
  for (std::size_t g = 0; g < scene.groups.size(); ++g)
    for (const Shape& shape : scene.groups[g].shapes) {
      const std::optional<double> free_path = free_path_within(scene, shape);
      const std::optional<Box> box = free_path ? bounds(shape) : std::nullopt;
      if (!box) continue;
      for (const Instance& instance : scene.instances)
        if (static_cast<std::size_t>(instance.group) == g)
          if (auto found = warning(shape, *free_path, bounds(*box, instance.world_from_group))) return found;
    }
  return std::nullopt;
}

}  // namespace strahl
