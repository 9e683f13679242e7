// SPDX-License-Identifier: MIT
// Without a surface that reflects, paths end at the first hit. Light is reflected once at most where the only surface
// that reflects is convex: no ray that leaves it meets it again.
#include "scene/auto_integrator.h"

#include <algorithm>
#include <variant>
#include <vector>

#include "kinds/lights.h"
#include "kinds/materials.h"
#include "scene/beams.h"
#include "scene/light_path_fault.h"
#include "scene/unseen.h"

namespace strahl {

namespace {

/// On both sides.
bool is_black(const Scene& scene, int index) {
  const Material& material = scene.materials.at(static_cast<std::size_t>(index));
  const auto* diffuse = std::get_if<Diffuse>(&material.bsdf);
  if (diffuse == nullptr || diffuse->reflectance.texture >= 0 || diffuse->reflectance.color != Rgb{0, 0, 0})
    return false;
  return material.back < 0 || is_black(scene, material.back);
}

bool reflects(const Shape& shape, const Scene& scene) {
  const auto is_reflecting = [&](int material) { return !is_black(scene, material); };
  const auto* mesh = std::get_if<Mesh>(&shape.geometry);
  if (mesh == nullptr || mesh->parts.empty()) return is_reflecting(shape.material);
  return std::any_of(mesh->parts.begin(), mesh->parts.end(),
                     [&](const MeshPart& part) { return is_reflecting(part.material); });
}

/// Of the sides that reflect.
bool is_convex(const Shape& shape, const Material& material, const Scene& scene) {
  const Geometry& g = shape.geometry;
  if (std::holds_alternative<Plane>(g) || std::holds_alternative<Rectangle>(g) || std::holds_alternative<Triangle>(g) ||
      std::holds_alternative<Disk>(g))
    return true;
  const bool is_closed =
      std::holds_alternative<Sphere>(g) || std::holds_alternative<Box>(g) || std::holds_alternative<Cube>(g);
  if (!is_closed || shape.flip_normals || material.twosided) return false;
  return !any_inside(scene, material, [](const Material& inside) { return inside.twosided; });
}

/// They shine under direct, which takes all lamps, and not under path, which draws them.
bool has_undrawn_lamps(const Scene& scene) {
  return std::ranges::any_of(scene.lights, [](const Light& light) {
    return light.sampling_weight == 0 && kinds::light(light).is_delta && kinds::gives_light(light);
  });
}

struct IntegratorChoice {
  const char* name;
  const char* why;
};

bool has_media(const Scene& scene) {
  bool has = scene.camera.medium >= 0;
  for_each_shape(scene, [&](const Shape& shape) { has = has || shape.media.has_value(); });
  return has;
}

/// On a shape, whatever else the scene names.
bool has_masks(const Scene& scene) {
  bool has = false;
  for_each_shape(scene, [&](const Shape& shape) { has = has || is_masked(shape, scene); });
  return has;
}

IntegratorChoice integrator_for(const Scene& scene) {
  if (has_media(scene)) return {"volpath", "media lie between surfaces"};
  if (scene.integrator.max_depth == 0) return {"direct", "max_depth leaves no light"};
  if (scene.integrator.max_depth == 1) return {"emission", "max_depth leaves nothing but emission"};
  std::vector<const Shape*> reflecting;
  for_each_shape(scene, [&](const Shape& shape) {
    if (reflecting.size() < 2 && reflects(shape, scene)) reflecting.push_back(&shape);
  });
  const bool is_open = has_masks(scene);
  if (reflecting.empty() && !is_open) return {"emission", "no surface reflects light"};
  if (has_beams_alone(scene) && takes_light_paths(scene, "ptracer"))
    return {"ptracer", "all light leaves its places in one direction each, so that only paths from there find it"};
  if (has_undrawn_lamps(scene))
    return {"path", "a lamp has a sampling_weight of 0, and direct would take it all the same"};
  if (scene.integrator.max_depth == 2) return {"direct", "max_depth lets light be reflected once"};
  if (is_open) return {"path", "light goes on through masks"};
  if (reflecting.size() == 1 && scene.groups.empty()) {
    const Shape& shape = *reflecting.front();
    const Material& material = scene.materials.at(static_cast<std::size_t>(shape.material));
    if (is_convex(shape, material, scene) &&
        (lobes_of(scene, material) & (lobes::LOBE_DELTA | lobes::LOBE_TRANSMIT)) == 0)
      return {"direct", "the only surface that reflects is convex, so light is reflected once at most"};
  }
  return {"path", "light may be reflected more than once"};
}

}  // namespace

void choose_integrator(Scene& scene) {
  const IntegratorChoice choice = integrator_for(scene);
  scene.integrator.name = choice.name;
  scene.integrator.why = choice.why;
}

void simplify_integrator(Scene& scene) {
  if (scene.integrator.name != "volpath" || has_media(scene) || has_masks(scene) || has_panes(scene)) return;
  scene.integrator.name = "path";
}

}  // namespace strahl
