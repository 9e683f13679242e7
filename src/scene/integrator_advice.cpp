// SPDX-License-Identifier: MIT
#include "scene/integrator_advice.h"

#include <cmath>
#include <optional>

#include "kinds/integrators.h"
#include "kinds/lights.h"
#include "kinds/materials.h"
#include "scene/auto_integrator.h"
#include "scene/beams.h"
#include "scene/light_path_fault.h"

namespace strahl {
namespace {

using Where = std::optional<SourceLocation>;

/// A surface that sends light on in one direction alone, as mirrors and smooth glass do.
Where first_mirror(const Scene& scene) {
  Where found;
  const auto is_mirror = [&](int material) {
    return (lobes_of(scene, scene.materials.at(static_cast<std::size_t>(material))) & lobes::LOBE_DELTA) != 0;
  };
  for_each_shape(scene, [&](const Shape& shape) {
    const auto* mesh = std::get_if<Mesh>(&shape.geometry);
    bool has = (mesh == nullptr || mesh->parts.empty()) && is_mirror(shape.material);
    if (mesh != nullptr)
      for (const MeshPart& part : mesh->parts) has = has || is_mirror(part.material);
    if (has && !found) found = shape.where;
  });
  return found;
}

/// A lamp that no ray hits.
Where first_point(const Scene& scene) {
  for (const Light& light : scene.lights)
    if (kinds::light(light).is_delta && !kinds::light(light).is_beam && kinds::gives_light(light)) return light.where;
  return {};
}

double diagonal(const std::optional<Box>& box) {
  if (!box) return 0;
  const Vec3 size = box->max - box->min;
  return std::sqrt(dot(size, size));
}

/// An emitter that is small beside the scene: paths from the camera seldom hit it.
Where first_small_lamp(const Scene& scene) {
  constexpr double small = 1.0 / 30;
  const double all = diagonal(bounds(scene));
  for (const Shape& shape : scene.shapes) {
    if (!shape.radiance) continue;
    const std::optional<Box> own = bounds(shape);
    if (own && diagonal(own) < small * all) return shape.where;
  }
  return {};
}

Where first_mask(const Scene& scene) {
  for (const Material& material : scene.materials)
    if (material_facts(material).opacity) return material.where;
  return {};
}

}  // namespace

std::vector<Advice> integrator_advice(const Scene& scene) {
  const kinds::IntegratorFacts& facts = kinds::integrator(scene.integrator.name);
  if (!facts.is_lit()) return {};
  std::vector<Advice> all;
  if (!scene.media.empty() && !facts.goes_through)
    all.push_back({"volpath", "a medium, which is taken for empty space", scene.media.front().where});
  const Where point = first_point(scene);
  const Where mask = first_mask(scene);
  if (point && mask && !facts.goes_through && !facts.from_lights && scene.media.empty())
    all.push_back({"volpath", "the light of a point or from far away, which surfaces with an opacity block", *mask});
  const Where mirror = first_mirror(scene);
  const std::vector<SourceLocation> beams = beams_of(scene);
  if (facts.from_lights) return all;
  const bool has_bdpt = takes_light_paths(scene, "bdpt"), has_ptracer = takes_light_paths(scene, "ptracer");
  if (!beams.empty() && has_ptracer)
    all.push_back({(has_beams_alone(scene) && !mirror) || !has_bdpt ? "ptracer" : "bdpt",
                   "the light of a beam, which no ray from the camera or a surface finds", beams.front()});
  if (!mirror || !has_bdpt) return all;
  if (point)
    all.push_back({"bdpt", "what mirrors and glass throw of a lamp that no ray from the camera hits", *point});
  else if (const Where lamp = first_small_lamp(scene))
    all.push_back({"bdpt", "what mirrors and glass throw of a small lamp, found by chance alone", *lamp});
  return all;
}

std::vector<std::string> integrator_misses(const Scene& scene) {
  std::vector<std::string> misses;
  for (const Advice& advice : integrator_advice(scene)) misses.push_back(advice.why);
  const kinds::IntegratorFacts& facts = kinds::integrator(scene.integrator.name);
  const bool is_direct = facts.follows == kinds::Follows::one_way,
             is_whitted = facts.follows == kinds::Follows::mirrors;
  if (is_direct || is_whitted) {
    Scene whole = scene;
    for (Light& light : whole.lights) light.sampling_weight = 1;  // Of 0 it is a reason for path that misses nothing.
    choose_integrator(whole);
    if (kinds::integrator(whole.integrator.name).follows == kinds::Follows::paths)
      misses.emplace_back(is_direct ? "light that surfaces reflect more than once"
                                    : "light that surfaces reflect more than once, but for mirrors and glass");
  }
  if (facts.from_lights && !facts.from_camera && first_mirror(scene))
    misses.emplace_back("what the camera sees in mirrors and through smooth glass");
  return misses;
}

}  // namespace strahl
